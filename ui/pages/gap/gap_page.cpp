// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_page.h"

#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "core/archive/result_scenario.h"
#include "core/report/blow_csv.h"
#include "core/report/gap_json.h"
#include "ui/form/choice_box.h"
#include "ui/pages/gap/gap_plot.h"
#include "ui/pages/gap/scatter_fields.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

bool isDimensional(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional;
}

// A drill string has no curve to lay over others.
bool isCompared(const Run& run) {
    return run.isShown && run.isSolved() && !isString(run.contents.scenario);
}

// Its gap is where its mark is, and matters no further.
Scenario withoutGap(const Run& run) {
    return gapQuestion(run.contents.scenario, {}).scenario;
}

}  // namespace

GapPage::GapPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_output(outputBox()),
      m_scatter(new ScatterFields(this)),
      m_curve(curveButton()),
      m_study(&answer),
      m_runGaps(runGap) {
    PlotWidget* plot =
        arrange(QList<QWidget*>{m_output, m_scatter} + m_scatter->fields() + QList<QWidget*>{m_curve});
    m_plot = new GapPlot(plot);
    useFrame(*m_plot, tr("Result over the gap, and how its values are distributed"));
    watch(m_study.job());
    watchBeside(m_runGaps.activity());
    connect(m_output, &QComboBox::currentIndexChanged, this, &GapPage::present);
    connect(m_scatter, &ScatterFields::changed, this, &GapPage::askSoon);
    connect(plot, &PlotWidget::clicked, this,
            [this](const QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers) {
                if (!m_plot->isDistribution(rect)) takeGap(at.x(), modifiers);
            });
}

ChoiceBox* GapPage::outputBox() {
    auto* box = new ChoiceBox(this);
    box->setObjectName(QStringLiteral("output"));
    box->setAccessibleName(tr("Result"));
    box->setToolTip(tr("Which result is shown"));
    for (const GapOutput output : {GapOutput::cor, GapOutput::peakForce, GapOutput::efficiency})
        box->addItem(gapOutputName(output), static_cast<int>(output));
    return box;
}

QPushButton* GapPage::curveButton() {
    auto* button = new QPushButton(tr("Results over the gap"), this);
    button->setObjectName(QStringLiteral("curve"));
    button->setToolTip(tr("The page Efficiency–stiffness with the gap as what is varied"));
    button->hide();
    connect(button, &QPushButton::clicked, this, &GapPage::curveRequested);
    return button;
}

GapOutput GapPage::output() const {
    return static_cast<GapOutput>(m_output->currentData().toInt());
}

// Its controls are of gaps that have a period.
void GapPage::followForm() {
    const bool ofString = isString(scenario());
    m_curve->setVisible(ofString);
    findChild<QPushButton*>(QStringLiteral("copyCommand"))->setVisible(!ofString);
    m_output->setVisible(!ofString);
    m_scatter->setVisible(!ofString);
    for (QWidget* box : m_scatter->fields()) box->setVisible(!ofString && m_scatter->normal().has_value());
}

void GapPage::ask() {
    followForm();
    if (isString(scenario())) {
        m_study.ask(gapQuestion(scenario(), {}));
        return;
    }
    m_scatter->present(scenario());
    m_study.ask(gapQuestion(scenario(), m_scatter->normal()));
}

GapPage::Shown GapPage::wanted() const {
    Shown wanted{.answer = m_study.job().value(), .output = output(), .units = {}};
    if (!wanted.answer) return wanted;
    const Scenario& studied = wanted.answer->report.scenario;
    const Scales scales = scalesOf(studied);
    wanted.units = blow() && isDimensional(studied)
                       ? shownUnits(blow()->request.units, scales, blow()->request.chosenUnits)
                       : shownUnits(naturalUnits(studied), scales);
    return wanted;
}

void GapPage::present() {
    Shown shown = wanted();
    if (!shown.answer) return;
    const bool isNew = !(shown == m_shown);
    if (isNew) m_shown = std::move(shown);
    if (const QString& why = m_shown.answer->problem; !why.isEmpty()) {
        if (isNew) showNothing(why);
        return;
    }
    if (isNew) draw();
    if (isString(scenario())) return;  // its answer is on the way
    placeHere();
    askRuns();
    showRuns();
}

void GapPage::askRuns() {
    std::vector<Scenario> scenarios;
    for (const Run& run : runs())
        if (isCompared(run)) scenarios.push_back(withoutGap(run));
    m_runGaps.ask(scenarios);
}

void GapPage::showRuns() {
    if (!m_runGaps.answers()) return;
    if (m_shownRuns == runList() && m_shownGaps == m_runGaps.answers()) return;
    m_shownRuns = runList();
    m_shownGaps = m_runGaps.answers();
    QVector<RunCurve> curves;
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!isCompared(run)) continue;
        const auto units = unitsOf(*run.blow, m_shown.units, scalesOf(m_shown.answer->report.scenario));
        const GapCurve* found = m_runGaps.find(withoutGap(run));
        if (!units || !found) continue;
        const double value = m_shown.output == GapOutput::peakForce ? units->force.factor : 1;
        const GapCurve& curve = *found;
        curves.append({run.number, run.title(),
                       runGapCurve(curve, m_shown.output, units->penetration.factor, value, m_picture.to)});
        const double own = groupsOf(run.contents.scenario).delta;
        if (own >= curve.start && own * units->penetration.factor <= m_picture.to)
            marks.append(
                {run.number, run.letter(),
                 QPointF(own * units->penetration.factor, curve.value(m_shown.output, own) * value)});
    }
    m_plot->setRuns(marks, curves);
    for (const QCPGraph* graph : m_plot->runCurves()) plot()->setMeaning(graph, meaning());
    plot()->replot(QCustomPlot::rpQueuedReplot);
}

CurveMeaning GapPage::meaning() const {
    return {.xUnit = m_picture.gap.dimensionless ? QString() : m_picture.gap.unit,
            .yUnit = m_picture.value.unit};
}

void GapPage::draw() {
    const GapAnswer& found = *m_shown.answer;
    m_picture = found.isComplete() ? gapPicture(found.report, m_shown.output, m_shown.units)
                                   : gapPreview(found.samples, m_shown.output, m_shown.units);
    m_plot->present(m_picture);
    m_shownRuns.reset();  // over other gaps or in other units
    CurveMeaning meaning = this->meaning();
    if (found.isComplete())
        meaning.value = [answer = m_shown.answer, output = m_shown.output, gap = m_picture.gap.factor,
                         value = m_picture.value.factor, from = found.report.curve.start](double x) {
            return answer->report.curve.value(output, std::max(from, x / gap)) * value;
        };
    plot()->setMeaning(m_plot->graph(), meaning);
    say(sentence());
    redraw();
}

void GapPage::showNothing(const QString& why) {
    m_plot->showNothing(why);
    plot()->setAccessibleDescription(why);
    say(
        tr("A drill string has no curve of gaps that repeat. “Results over the gap” shows any result over "
           "the gap point by point, without a distribution."));
    plot()->replot(QCustomPlot::rpQueuedReplot);
}

QString GapPage::obstacle() const {
    if (QString unfinished = StudyPage::obstacle(); !unfinished.isEmpty()) return unfinished;
    return m_shown.answer ? m_shown.answer->problem : QString();
}

// On the curve that is shown, and in its period: beyond it everything repeats.
void GapPage::placeHere() {
    const GapCurve& curve = m_shown.answer->report.curve;
    if (!m_shown.answer->isComplete()) return m_plot->setHere({}, {});
    double gap = groupsOf(scenario()).delta;
    if (gap < curve.start) return m_plot->setHere({}, {});  // before all periods
    if (gap >= curve.end) gap = curve.periodStart + (gap - std::floor(gap));
    m_plot->setHere(gap * m_picture.gap.factor, curve.value(m_shown.output, gap) * m_picture.value.factor);
}

// A click in the plot.
void GapPage::takeGap(double shownGap, Qt::KeyboardModifiers modifiers) {
    if (!m_shown.answer || isString(scenario())) return;
    const double gap = std::max(0.0, shownGap / m_picture.gap.factor);
    if (isDimensional(scenario()))
        take({{findParameter("bit_rock.gap"), gap * scalesOf(scenario()).penetration}}, modifiers);
    else
        take({{findParameter("delta"), gap}}, modifiers);
}

QString GapPage::sentence() const {
    const GapReport& report = m_shown.answer->report;
    if (!m_shown.answer->isComplete()) return tr("A first look; the curve follows.");
    if (const std::string remark = report.periodRemark(); !remark.empty())
        return QString::fromStdString(remark);
    const QLocale locale;
    const QString period =
        m_picture.gap.dimensionless ? tr("d₀") : tr("d₀ = %1").arg(quantityText(1, m_picture.gap, locale));
    return tr("Results repeat with every %1 of gap. A click in the plot takes over the gap there, with Shift "
              "it pins it.")
        .arg(period);
}

QByteArray GapPage::csv() const {
    GapReport report = m_study.value()->report;
    const OutputUnits units = isDimensional(report.scenario) ? OutputUnits::si : OutputUnits::dimensionless;
    return QByteArray::fromStdString(scenarioHeader(completeScenarioText(document().contents())) +
                                     gapCsv(report, units));
}

QStringList GapPage::commandWords() const {
    if (isString(scenario())) return {};
    QStringList words{QStringLiteral("gap")};
    words << m_scatter->commandWords();
    if (isDimensional(scenario())) words << QStringLiteral("--si");
    return words;
}

}  // namespace drillwave
