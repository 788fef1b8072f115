// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_page.h"

#include <QBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/archive/result_scenario.h"
#include "core/blow/feed_estimate.h"
#include "core/report/blow_csv.h"
#include "core/report/feed_words.h"
#include "core/report/thrust_report.h"
#include "ui/form/rig_dialog.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/thrust/missing_fields.h"
#include "ui/pages/thrust/thrust_drag.h"
#include "ui/pages/thrust/thrust_plot.h"
#include "ui/pages/thrust/thrust_table.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::string_view thrustKey = "drill.thrust";

// A value that the hand has chosen to a pixel needs no more digits than that.
double readable(double value, const QCPAxis& axis, double pixel) {
    const double step = std::abs(axis.pixelToCoord(pixel + 1) - axis.pixelToCoord(pixel));
    if (!(step > 0) || !std::isfinite(step) || value == 0) return value;
    constexpr int most = 15;  // digits that a double keeps
    const double digits = std::floor(std::log10(std::abs(value) / step)) + 1;
    // Through text: 0.3, not 0.30000000000000004.
    return QString::number(value, 'g', std::clamp(int(digits), 1, most)).toDouble();
}

}  // namespace

ThrustPage::ThrustPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_axis(new AxisFields(tr("over"), {"drill.blow_frequency"}, document.units(), this)),
      m_missing(new MissingFields({"drill.blow_frequency", thrustKey}, document.units(), this)),
      m_table(new ThrustTable(this)),
      m_study([student = std::make_shared<ThrustStudent>()](const ThrustQuestion& question,
                                                            const StudyFeed<ThrustAnswer>& feed) {
          return student->answer(question, feed);
      }) {
    PlotWidget* widget = arrange({m_axis, m_missing});
    addBelow(m_table);
    m_plot = new ThrustPlot(widget);
    m_drag = new ThrustDrag(*widget, *m_plot);
    useFrame(*m_plot, tr("Required feed"));
    watch(m_study.job());
    connect(m_axis, &AxisFields::changed, this, &ThrustPage::askSoon);
    connect(m_missing, &MissingFields::entered, this, [this](const KeptParameter& parameter, double si) {
        load({{parameter, si}});
    });
    connect(widget, &PlotWidget::placeTaken, this,
            [this](const QCPAxisRect*, QPointF at, Qt::KeyboardModifiers modifiers) {
                takeParameter(at.x(), modifiers);
            });
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        if (isVisible()) present();
    });
    connect(m_drag, &ThrustDrag::begun, this, &ThrustPage::hold);
    connect(m_drag, &ThrustDrag::moved, this, &ThrustPage::moveHeld);
}

QString ThrustPage::elsewhere() const {
    return tr("Thrust is of scenarios in physical units, and this one is given by its dimensionless groups: "
              "without a blow frequency and forces no feed can be judged.") +
           QLatin1Char(' ') + waysToPhysicalUnits();
}

void ThrustPage::ask() {
    m_missing->present(scenario());
    {
        const QSignalBlocker quiet(m_axis);  // what it chooses now is asked for right here
        m_axis->present(scenario());
    }
    m_study.ask({scenario(), m_axis->range()});
}

void ThrustPage::present() {
    const std::shared_ptr<const ThrustAnswer> answer = m_study.job().value();
    if (!answer) return;
    if (!answer->problem.isEmpty()) return refuse(translated(requiredFeedMessage(answer->scenario, {})));
    if (!answer->here.reason.isEmpty()) return refuse(translated(answer->here.reason));
    const UnitChoice& choice = document().units();
    const ThrustUnits units =
        thrustUnits(answer->scenario, choice.fieldUnit(*answer->along.axis.parameter),
                    shownUnits(choice.physicalSystem(), scalesOf(answer->scenario), choice.chosen()));
    if (answer != m_shown || !(units == m_units)) {
        m_shown = answer;
        m_units = units;
        draw(*answer);
    }
    placeHere(*answer);
    showRuns(*answer);
}

// By what each needs for full penetration, f I0 (1 + e).
void ThrustPage::showRuns(const ThrustAnswer& answer) {
    const Parameter& along = *answer.along.axis.parameter;
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!run.isShown || !run.isSolved() || !along.applies(run.contents.scenario)) continue;
        const std::optional<double> x = along.value(run.contents.scenario);
        const std::optional<double> need =
            thrustNeeded(run.contents.scenario, run.blow->summary.cor, run.blow->summary.transferred);
        if (x && need)
            marks.append(
                {run.number, run.title(), {*x * m_units.along.factor, *need * m_units.force.factor}});
    }
    m_plot->setRuns(marks);
}

void ThrustPage::draw(const ThrustAnswer& answer) {
    m_plot->present(thrustPicture(answer.along, m_units));
    for (const ThrustCase which : thrustCases) {
        const CurveMeaning meaning = CurveMeaning::overParameter(m_units.along.unit, m_units.force.unit);
        plot()->setMeaning(m_plot->need(which), meaning);
        plot()->setMeaning(m_plot->feed(), meaning);
    }
    m_table->present(answer.here.feed, m_units);
    say(translatedEach(
        thrustSentences(answer.scenario, answer.here.feed, {}, LocalStyle::of(document().units()))));
    redraw();
}

void ThrustPage::placeHere(const ThrustAnswer& answer) {
    const std::optional<double> force = answer.here.feed.effective();
    const bool isShown = m_study.job().isCurrent() && std::isfinite(answer.here.value);
    m_plot->setHere(isShown ? std::optional(answer.here.value * m_units.along.factor) : std::nullopt,
                    force ? std::optional(*force * m_units.force.factor) : std::nullopt);
    m_drag->setEnabled(force && answer.along.axis.key() != thrustKey);
}

void ThrustPage::refuse(const QString& why) {
    m_shown = nullptr;
    m_drag->setEnabled(false);
    m_table->clearNumbers();
    showNothing(why);
}

// A click in the plot.
void ThrustPage::takeParameter(double shown, Qt::KeyboardModifiers modifiers) {
    if (!m_shown) return;
    const QCPAxis& axis = *plot()->xAxis;
    take({{m_shown->along.axis.parameter,
           readable(shown, axis, axis.coordToPixel(shown)) / m_units.along.factor}},
         modifiers);
}

void ThrustPage::hold(double shownForce) {
    m_held = {document().newGesture(), scenario().drill.thrust.value_or(0),
              shownForce / m_units.force.factor};
}

// The line is the effective force, wherever it was taken hold of: the thrust moves by as much.
void ThrustPage::moveHeld(double shownForce) {
    const QCPAxis& axis = *plot()->yAxis;
    const double thrust = m_held.thrust + shownForce / m_units.force.factor - m_held.force;
    const double shown = std::max(0.0, thrust * m_units.force.factor);
    document().assign(*findParameter(thrustKey),
                      readable(shown, axis, axis.coordToPixel(shown)) / m_units.force.factor, m_held.gesture);
}

QString ThrustPage::obstacle() const {
    if (QString unfinished = StudyPage::obstacle(); !unfinished.isEmpty()) return unfinished;
    return m_shown ? QString() : translated(m_study.value()->problem);
}

QByteArray ThrustPage::csv() const {
    return QByteArray::fromStdString(scenarioHeader(completeScenarioText(document().contents())) +
                                     thrustCsv(m_study.value()->along));
}

QStringList ThrustPage::commandWords() const {
    if (!thrustProblem(scenario()).isEmpty()) return {};
    return {QStringLiteral("thrust"), QStringLiteral("--along"), fromView(axisText(m_axis->range()))};
}

}  // namespace drillwave
