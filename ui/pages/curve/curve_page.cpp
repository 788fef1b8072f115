// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/curve_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <algorithm>
#include <utility>

#include "core/model/section_parameter.h"
#include "core/numeric/available_threads.h"
#include "core/report/curve_figure.h"
#include "core/report/curve_report.h"
#include "core/study/rows/study_plan.h"
#include "ui/form/choice_box.h"
#include "ui/job/output_text.h"
#include "ui/pages/curve/goal_field.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/family_fields.h"
#include "ui/pages/study/labelled_control.h"
#include "ui/pages/study/output_box.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_quantity.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

std::vector<StudyFamily> preferredFamilies() {
    const std::vector<double> gammas{0.01, 0.1, 0.3, 1};
    return {{findParameter("bit_rock.gamma"), gammas}, {findParameter("gamma"), gammas}};
}

/// Numbers of points that a curve of a drill string may have.
constexpr int pointsOfCurve[] = {51, 101, 201, 401, 1001};

ComparedCurve solve(const ComparedCurveQuestion& question, const StudyFeed<ComparedCurve>& feed) {
    constexpr double parts = 1000;
    return studyComparedCurve(
        question, availableThreads(), feed.stop,
        [&](double done) {
            feed.tell({static_cast<std::size_t>(done * parts), static_cast<std::size_t>(parts)});
        },
        [&](const ComparedCurve& soFar) { feed.show(soFar); });
}

std::optional<CurveStudy> solveRun(const CurveQuestion& question, const std::stop_token& stop) {
    constexpr int jobs = 1;  // the others are left to the study of the scenario
    CurveStudy study = studyComparedCurve({question}, jobs, stop).curve;
    if (study.stopped) return std::nullopt;
    return study;
}

}  // namespace

CurvePage::CurvePage(Document& document, QWidget* parent)
    : StudyPage(document, parent), m_study(solve), m_runLines(solveRun) {
    PlotWidget* plot = arrange(makeControls());
    m_frame = new FigureFrame(plot);
    watch(m_study.job());
    watchBeside(m_runLines.activity());
    useFrame(*m_frame, tr("A result over a parameter"));
    connect(plot, &PlotWidget::placeTaken, this, &CurvePage::click);
    connect(&document.units(), &UnitChoice::changed, this, &CurvePage::requestUpdate);
    connect(&document, &Document::scenarioChanged, this, &CurvePage::followForm);
}

QList<QWidget*> CurvePage::makeControls() {
    m_axis = new AxisFields(tr("vary"), {"bit_rock.stiffness", "beta"}, document().units(), this);
    m_family = new FamilyFields(tr("curves for"), preferredFamilies(), document().units(), this);
    m_own = new QCheckBox(tr("this scenario"), this);
    m_own->setObjectName(QStringLiteral("own"));
    m_own->setToolTip(tr("Also a curve for the scenario's own value of the family"));
    m_own->setChecked(true);
    m_output = new OutputBox(this, OfferedOutputs::ofOneBlow);
    m_goal = new GoalField(this);
    m_closedForm = new QCheckBox(tr("closed form"), this);
    m_closedForm->setObjectName(QStringLiteral("closedForm"));
    m_closedForm->setToolTip(tr(
        "The paper's analytical solution, drawn where it is valid: rectangular blow, elastic rock (γ = 1)"));
    m_reference = new QComboBox(this);
    ignoreUnfocusedWheel(*m_reference);
    m_reference->setObjectName(QStringLiteral("reference"));
    m_reference->setAccessibleName(tr("Rod without waves"));
    m_reference->setToolTip(
        tr("A rod that arrives without waves, dotted, over its stiffness in one of two units"));
    m_reference->addItem(tr("no curve to compare with"));
    m_reference->addItem(tr("rod without waves, k₀ = Z/(2T)"));
    m_reference->addItem(tr("rod without waves, k₀ = Z/t₀"));
    connect(m_axis, &AxisFields::changed, this, &CurvePage::requestUpdate);
    connect(m_family, &FamilyFields::changed, this, &CurvePage::requestUpdate);
    connect(m_output, &OutputBox::changed, this, &CurvePage::requestUpdate);
    connect(m_goal, &GoalField::changed, this, &CurvePage::takeGoal);
    connect(m_reference, &QComboBox::currentIndexChanged, this, &CurvePage::requestUpdate);
    for (QCheckBox* box : {m_own, m_closedForm})
        connect(box, &QCheckBox::toggled, this, &CurvePage::requestUpdate);
    m_pointsPart = makePointsBox();
    QWidget* goal = labelled(tr("goal"), m_goal, this);
    return {m_axis, m_output, goal, m_family, m_own, m_pointsPart, m_closedForm, m_reference};
}

QWidget* CurvePage::makePointsBox() {
    m_points = new ChoiceBox(this);
    m_points->setObjectName(QStringLiteral("points"));
    m_points->setAccessibleName(tr("Points of a curve"));
    m_points->setToolTip(tr("Number of blows solved along a curve of a drill string"));
    for (const int points : pointsOfCurve) m_points->addItem(QString::number(points), points);
    m_points->setCurrentIndex(m_points->findData(int(sampledPoints)));
    connect(m_points, &QComboBox::currentIndexChanged, this, &CurvePage::requestUpdate);
    QWidget* part = labelled(tr("points"), m_points, this);
    part->hide();
    return part;
}

QString CurvePage::title() const {
    return m_isSampled ? tr("Efficiency–stiffness") : tr("COR–stiffness");
}

void CurvePage::varyGap() {
    constexpr double blows = 4;  // d0: beyond, the bit hardly ever is
    const std::string_view key = hasUnits(scenario()) ? "bit_rock.gap" : "delta";
    const Parameter& gap = *findParameter(key);
    const double d0 = hasUnits(scenario()) ? scalesOf(scenario()).penetration : 1;
    m_axis->present(scenario());
    m_axis->setRange(
        {gap, 0, readableNear(gap, std::max(blows * d0, 2 * gap.value(scenario()).value_or(0))), false});
}

// Asks for one curve, which has the answer. Sections of one name are changed by that name.
void CurvePage::seek(const KeptParameter& parameter) {
    KeptParameter varied = parameter;
    if (const std::string called = sectionName(*parameter, scenario()); !called.empty())
        for (const KeptParameter& each : variableSectionParameters(scenario()))
            if (each->address && each->address->field == parameter->address->field &&
                each->address->chain == parameter->address->chain && each->address->isCalled(called))
                varied = each;
    m_axis->present(scenario());
    m_axis->setRange(rangeAround(*varied, scenario()));
    m_family->setFamily({});
    m_goal->setFocus(Qt::OtherFocusReason);
    m_goal->selectAll();
}

OutputColumn CurvePage::column() const {
    const bool isPhysical = hasUnits(scenario()) && document().units().system() != UnitSystem::dimensionless;
    const Output& output = m_output->output();
    const bool isShare = output.measure == Measure::energy;
    return {&output, isPhysical && !isShare ? OutputUnits::si : OutputUnits::dimensionless};
}

void CurvePage::takeGoal() {
    const OutputColumn of = column();
    m_goals.erase(of.output);
    if (m_goal->value()) m_goals[of.output] = {*m_goal->value(), of.units};
    requestUpdate();
}

// Converts the goal if the results have other units since, by the scales of the scenario.
std::optional<double> CurvePage::askedGoal(const OutputColumn& of) const {
    const auto found = m_goals.find(of.output);
    if (found == m_goals.end()) return std::nullopt;
    const Goal& goal = found->second;
    if (goal.units == of.units || of.output->isOnlySi()) return goal.value;
    const double scale = of.output->scale(scalesOf(scenario()));
    return of.units == OutputUnits::si ? goal.value * scale : goal.value / scale;
}

// Shows the goal in the unit of the results.
void CurvePage::showGoal() {
    const OutputColumn of = column();
    const std::optional<double> goal = askedGoal(of);
    const Quantity quantity = of.quantity();
    const Scales scales = scalesOf(scenario());
    const UnitSystem system =
        of.units == OutputUnits::si ? document().units().system() : UnitSystem::dimensionless;
    const ShownUnit shown =
        outputUnit(*of.output, shownUnits(system, scales, document().units().chosen()), goal.value_or(0));
    const Unit* unit = typedUnit(shown.unit, quantity);
    m_goal->present(goal, quantity, unit ? *unit : unitsOf(quantity).front());
}

// The paper's curves and its family of elasticities are of uniform rods.
void CurvePage::followForm() {
    const bool isSampled = studyPlan(scenario()).curvePoints.has_value();
    if (isSampled == m_isSampled) return;
    m_isSampled = isSampled;
    m_closedForm->setVisible(!isSampled);
    m_reference->setVisible(!isSampled);
    m_pointsPart->setVisible(isSampled);
    const std::vector<StudyFamily> ofRods = preferredFamilies();
    const bool isUsual = std::ranges::find(ofRods, m_family->family()) != ofRods.end();
    if (isSampled && (isUsual || !m_family->family().parameter)) m_family->setFamily({});
    if (!isSampled && !m_family->family().parameter)
        m_family->setFamily(ofRods[hasUnits(scenario()) ? 0 : 1]);
    emit titleChanged();
}

/// Returns the axis as in the command: a range to be followed, or with a number of points.
std::string CurvePage::axisText() const {
    const StudyRange& range = m_axis->range();
    if (!m_isSampled) return range.text() + range.tail();
    const auto most = static_cast<std::uint64_t>(m_points->currentData().toInt());
    return range.text() + ":" + std::to_string(range.pointsWithin(most)) + range.tail();
}

std::optional<double> CurvePage::hereOf(const KeptParameter& parameter) const {
    if (!parameter || !parameter->applies(scenario())) return std::nullopt;
    return parameter->value(scenario());
}

/// Returns the family, including the value of the scenario if that is wanted.
StudyFamily CurvePage::askedFamily() const {
    StudyFamily family = m_family->family();
    const std::optional<double> own = hereOf(family.parameter);
    if (!m_own->isChecked() || !own) return family;
    if (std::ranges::find(family.values, *own) == family.values.end()) family.values.push_back(*own);
    return family;
}

// Built from the words of the command, so that both have the same values.
CurvePage::Wish CurvePage::wish() const {
    const StudyRange& range = m_axis->range();
    if (!range.parameter) return {};
    ComparedCurveQuestion asked;
    CurveQuestion& curve = asked.curve;
    curve.base = scenario();
    curve.base.title.clear();
    const ParsedAxis along = m_isSampled ? parseAxis(axisText()) : parseRange(axisText());
    if (!along.problem.isEmpty()) return {{}, translated(along.problem)};
    curve.along = along.axis;
    takeOut(curve.base, *range.parameter, range.start);
    if (const StudyFamily family = askedFamily(); family.parameter) {
        const ParsedAxis values = parseAxis(family.text());
        if (!values.problem.isEmpty()) return {{}, translated(values.problem)};
        curve.family = values.axis;
        takeOut(curve.base, *family.parameter, family.values.front());
    }
    curve.columns = {column()};
    curve.goal = askedGoal(curve.columns.front());
    if (m_output->output().name == "cor" && !m_isSampled && curve.goal != 1) curve.levels = {1};
    asked.reference = static_cast<ReferenceScale>(m_reference->currentIndex());
    asked.closedForm = m_closedForm->isChecked();
    QStringList problems;
    for (const Message& problem : problemsOf(asked)) problems << translated(problem);
    if (!problems.isEmpty()) return {{}, problems.join(QLatin1Char('\n'))};
    return {std::move(asked), {}};
}

void CurvePage::ask() {
    followForm();
    m_axis->present(scenario());
    m_family->present(scenario());
    m_output->present(scenario());
    showGoal();
    Wish now = wish();
    m_problem = now.problem;
    if (!now.question) return m_study.job().cancel();
    m_reference->setEnabled(now.question->hasReference());
    m_closedForm->setEnabled(!m_isSampled && now.question->curve.base.pulse.shape == PulseShape::rectangular);
    m_study.ask(std::move(*now.question));
}

// Shows the problem instead of the curves, none of which can be clicked or written then.
void CurvePage::refuse(const QString& problem) {
    m_shown = {};
    m_figure.reset();
    showNothing(problem);
}

CurvePage::Shown CurvePage::wanted() const {
    Shown shown;
    shown.study = m_study.job().value();
    const CurveQuestion& asked = shown.study->question.curve;
    shown.units = unitsFor(asked.base);
    shown.xUnit = &document().units().fieldUnit(*asked.along.parameter);
    if (asked.family) shown.here = hereOf(asked.family->parameter);
    for (const PresetSource& source : m_presets.sources())
        shown.presets.insert(shown.presets.end(), source.presets.begin(), source.presets.end());
    return shown;
}

void CurvePage::present() {
    if (!m_problem.isEmpty()) return refuse(m_problem);
    if (m_study.job().state() == StudyState::failed) return refuse(m_study.job().problem());
    if (!m_study.value() || m_study.value()->curve.stopped || !blow()) return;
    if (Shown shown = wanted(); !(shown == m_shown)) {
        m_shown = std::move(shown);
        draw();
    }
    showHere();
    askRuns();
    showRuns();
}

void CurvePage::draw() {
    const LocalStyle style = LocalStyle::of(document().units());
    m_figure = curveFigure(*m_shown.study, m_shown.here, m_shown.presets, style);
    const std::vector<Message> sentences = curveSentences(*m_shown.study, m_shown.here, style);
    m_figure->summary = {{"%1", {{.words = sentences.front()}}}};
    const bool isFirst = m_frame->isEmpty();
    m_frame->present({*m_figure, {m_shown.units, [xUnit = m_shown.xUnit](const Parameter&) -> const Unit& {
                                      return *xUnit;
                                  }}});
    if (isFirst) plot()->keyPoint().offer(m_frame->keyPlaces());
    m_shownRuns.reset();  // over another range or in other units
    m_frame->giveMeanings(*plot());
    const bool isMarked = m_figure->panels.front().series.size() > m_figure->panels.front().marked;
    plot()->reader().setUsual(isMarked ? m_frame->graph(0, m_figure->panels.front().marked) : nullptr);
    say(translatedEach(sentences));
    redraw();
}

/// Uses the blow on show, which follows the hand.
void CurvePage::showHere() {
    const Point here = pointOf(*blow());
    m_frame->setHere(here.x, here.y);
}

// Along the range that is drawn, so that nothing is solved for a range that is passed by.
void CurvePage::askRuns() {
    std::vector<CurveQuestion> questions;
    for (const Run& run : runs()) {
        if (!run.isShown || !run.isSolved()) continue;
        if (auto own = questionOfRun(m_shown.study->question.curve, run.contents.scenario))
            questions.push_back(std::move(*own));
    }
    m_runLines.ask(questions);
}

void CurvePage::showRuns() {
    if (m_shownRuns == runList() && m_shownLines == m_runLines.answers()) return;
    m_shownRuns = runList();
    m_shownLines = m_runLines.answers();
    const CurveQuestion& asked = m_shown.study->question.curve;
    QVector<RunCurve> curves;
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!run.isShown || !run.isSolved()) continue;
        const Point place = pointOf(*run.blow);
        if (place.x && place.y) marks.append({run.number, run.letter(), {*place.x, *place.y}});
        const auto question = questionOfRun(asked, run.contents.scenario);
        const CurveStudy* found = question ? m_runLines.find(*question) : nullptr;
        if (!found) continue;
        const FigureSeries series = curveSeries(found->lines.front(), asked);
        QVector<QCPGraphData> points;
        for (std::size_t i = 0; i < series.x.size(); ++i)
            points.append({series.x[i] * m_frame->xUnit().factor, series.y[i] * m_frame->yUnit().factor});
        if (!points.isEmpty()) curves.append({run.number, run.title(), graphData(points)});
    }
    m_frame->setRuns(marks, curves);
    m_frame->giveMeanings(*plot());
    plot()->replot(QCustomPlot::rpQueuedReplot);
}

// Returns the place of a blow on the plot.
CurvePage::Point CurvePage::pointOf(const SolvedBlow& blow) const {
    if (!m_shown.study) return {};
    const CurveQuestion& asked = m_shown.study->question.curve;
    const OutputColumn& column = asked.columns.front();
    const Parameter& along = *asked.along.parameter;
    if (!along.applies(blow.scenario)) return {};
    if (column.units == OutputUnits::si && blow.scenario.form == ScenarioForm::dimensionless) return {};
    Point point;
    if (const std::optional<double> x = along.value(blow.scenario)) point.x = *x * m_frame->xUnit().factor;
    if (!blow.fault.isEmpty()) return point;
    if (const auto y = column.value({blow.summary, blow.scenario}, scalesOf(blow.scenario)))
        point.y = curveOrdinate(asked, *y) * m_frame->yUnit().factor;
    return point;
}

void CurvePage::showEvent(QShowEvent* event) {
    if (!event->spontaneous()) m_presets.reload();
    StudyPage::showEvent(event);
}

QString CurvePage::obstacle() const {
    return m_problem.isEmpty() ? StudyPage::obstacle() : m_problem;
}

QByteArray CurvePage::csv() const {
    const ComparedCurve* study = m_study.value();
    return study ? QByteArray::fromStdString(curveCsv(study->curve)) : QByteArray();
}

QStringList CurvePage::commandWords() const {
    const std::optional<ComparedCurveQuestion> asked = wish().question;
    if (!asked) return {};
    const QString along = fromView(axisText()), family = fromView(askedFamily().text());
    const CurveQuestion& curve = asked->curve;
    QStringList words;
    if (m_isSampled && curve.goal) {
        const StudyRange& range = m_axis->range();
        words << QStringLiteral("curve") << QStringLiteral("--along")
              << fromView(range.text() + range.tail());
        if (!family.isEmpty()) words << QStringLiteral("--family") << family;
    } else if (m_isSampled) {
        words << QStringLiteral("sweep");
        if (!family.isEmpty()) words << QStringLiteral("--vary") << family;
        words << QStringLiteral("--vary") << along;  // fastest
    } else {
        words << QStringLiteral("curve") << QStringLiteral("--along") << along;
        if (!family.isEmpty()) words << QStringLiteral("--family") << family;
    }
    words << QStringLiteral("--outputs") << fromView(curve.columns.front().output->name);
    for (const double level : curve.levels)
        words << QStringLiteral("--level") << fromView(formatNumber(level));
    if (curve.goal) words << QStringLiteral("--goal") << fromView(m_goal->commandText());
    if (curve.columns.front().units == OutputUnits::si) words << QStringLiteral("--si");
    return words;
}

// Returns the command for the goal if there is one, as it prints more than a column of numbers.
QString CurvePage::command() const {
    const QStringList words = commandWords();
    if (!words.contains(QStringLiteral("--goal"))) return StudyPage::command();
    return commandText(document(), words.first(), words.mid(1));
}

void CurvePage::click(QCPAxisRect*, QPointF coordinates, Qt::KeyboardModifiers modifiers) {
    if ((modifiers & ~Qt::ShiftModifier) || !m_shown.study) return;
    const FigureFrame::Target target = m_frame->targetAt(coordinates);
    std::vector<ParameterValue> values;
    if (target.series && target.series->parameter)
        values.push_back({target.series->parameter, target.series->value});
    values.push_back({m_shown.study->question.curve.along.parameter,
                      m_shown.xUnit->toSi(target.isMark ? target.x : readable(target.x))});
    take(values, modifiers);
}

}  // namespace drillwave
