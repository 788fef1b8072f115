// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_page.h"

#include <algorithm>
#include <cmath>

#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/report/blow_csv.h"
#include "core/report/gap_report.h"
#include "ui/form/choice_box.h"
#include "ui/pages/gap/gap_plot.h"
#include "ui/pages/gap/scatter_fields.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/local_style.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

bool isDimensional(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional;
}

// Others have no curve to lay over this one.
bool isCompared(const Run& run) {
    return run.isShown && run.isSolved() && gapHasPeriod(run.contents.scenario);
}

// Its gap is where its mark is, and matters no further.
Scenario withoutGap(const Run& run) {
    return gapQuestion(run.contents.scenario, {}).scenario;
}

}  // namespace

GapPage::GapPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_output(outputBox()),
      m_scatter(new ScatterFields(document.units(), this)),
      m_study(&answerGap),
      m_runGaps(runGap) {
    PlotWidget* plot = arrange(QList<QWidget*>{m_output, m_scatter} + m_scatter->fields());
    m_plot = new GapPlot(plot);
    useFrame(*m_plot, tr("Result over the gap, and how its values are distributed"));
    watch(m_study.job());
    watchBeside(m_runGaps.activity());
    connect(m_output, &QComboBox::currentIndexChanged, this, &GapPage::present);
    connect(m_scatter, &ScatterFields::changed, this, &GapPage::askSoon);
    connect(plot, &PlotWidget::placeTaken, this,
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

QString GapPage::elsewhere() const {
    return tr(
        "COR–gap is of uniform rods, whose results repeat over the gap; those of a drill string do not, and "
        "Efficiency–stiffness shows them over the gap point by point.");
}

GapOutput GapPage::output() const {
    return static_cast<GapOutput>(m_output->currentData().toInt());
}

void GapPage::ask() {
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
    if (isNew) draw();
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
    if (!m_shown.answer) return;
    const double gap = std::max(0.0, shownGap / m_picture.gap.factor);
    if (isDimensional(scenario()))
        take({{findParameter("bit_rock.gap"), gap * scalesOf(scenario()).penetration}}, modifiers);
    else
        take({{findParameter("delta"), gap}}, modifiers);
}

QString GapPage::sentence() const {
    const GapReport& report = m_shown.answer->report;
    if (!m_shown.answer->isComplete()) return tr("A first look; the curve follows.");
    if (const Message remark = report.periodRemark(LocalStyle::of(document().units())); !remark.isEmpty())
        return translated(remark);
    const QLocale locale;
    const QString period =
        m_picture.gap.dimensionless ? tr("d₀") : tr("d₀ = %1").arg(quantityText(1, m_picture.gap, locale));
    return tr("Results repeat with every %1 of gap. A click on the curve takes over the gap there, with "
              "Shift "
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
    QStringList words{QStringLiteral("gap")};
    words << m_scatter->commandWords();
    if (isDimensional(scenario())) words << QStringLiteral("--si");
    return words;
}

}  // namespace drillwave
