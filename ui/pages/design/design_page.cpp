// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_page.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>

#include "core/archive/result_scenario.h"
#include "core/model/scales.h"
#include "core/report/design_figure.h"
#include "core/report/design_report.h"
#include "core/report/design_words.h"
#include "core/report/report_studies.h"
#include "core/study/design/constant_energy.h"
#include "core/study/design/design_texts.h"
#include "core/study/rows/study_plan.h"
#include "ui/form/choice_box.h"
#include "ui/form/section_box.h"
#include "ui/job/study_status.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/design/design_card.h"
#include "ui/pages/design/preset_ticks.h"
#include "ui/pages/design/range_rows.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/labelled_control.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::size_t mostChoicesOfPage = 2;
constexpr int samplesOffered[] = {256, 1024, 4096, 16384, 65536};
const QString drawsStem = QStringLiteral("_posterior");
constexpr int plotLinesOfDesigns = 28;   // two rows of axes and readout
constexpr int plotLinesOfOneRow = 15;    // one row of axes
constexpr int plotLinesBesideBars = 22;  // the same without the inside of the row below
constexpr double legendLines = 1.6;      // lines of text that one row of the legend takes

}  // namespace

DesignPage::DesignPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_card(new DesignCard),
      m_plotLines(plotLinesOfDesigns),
      m_study(answerDesign) {
    m_drawsLine = makeDrawsLine();
    QWidget* questions = makeQuestions();
    m_refine = new QPushButton(this);
    m_refine->setObjectName(QStringLiteral("refine"));
    m_refine->setToolTip(tr("Solve all samples of this study; the time is an estimate"));
    m_refine->hide();
    connect(m_refine, &QPushButton::clicked, this, &DesignPage::refine);
    PlotWidget* widget = arrange({questions, m_keepEnergy, labelled(tr("samples"), m_samples, this)});
    settingsBox().rememberAs(QStringLiteral("design/settings"), SectionBox::Begin::folded);
    addAbove(m_drawsLine, PartOf::question);
    m_load = new QPushButton(this);
    m_load->setObjectName(QStringLiteral("load"));
    m_load->setToolTip(tr("Takes over this design as one undo step"));
    m_load->hide();
    connect(m_load, &QPushButton::clicked, this, [this] {
        if (!m_shown) return;
        if (const auto design = DesignCard::designToLoad(m_shown->report)) takeDesign(*design, {});
    });
    addAbove(m_load, PartOf::answer);
    addAbove(m_refine, PartOf::question);
    auto* details = new SectionBox(tr("Details"), this);
    details->setObjectName(QStringLiteral("details"));
    (new QVBoxLayout(details->content()))->addWidget(m_card);
    details->rememberAs(QStringLiteral("design/details"), SectionBox::Begin::folded);
    addAbove(details, PartOf::answer);
    m_frame = new FigureFrame(widget);
    useFrame(*m_frame, tr("Designs for uncertain inputs"));
    watch(m_study.job());
    m_study.job().setTimeLimit(
        std::chrono::milliseconds(0));  // it ends after its own seconds, with whole stages
    connect(widget, &PlotWidget::placeTaken, this, &DesignPage::click);
    connect(widget, &PlotWidget::afterLayout, this,
            [this] { setLeastLines(m_plotLines + int(std::ceil(legendLines * m_frame->legendRows()))); });
    connect(m_card, &DesignCard::designWanted, this,
            [this](std::uint64_t design) { takeDesign(design, {}); });
    connect(m_card, &DesignCard::worstWanted, this, &DesignPage::loadWorst);
    connect(&document, &Document::replaced, this, [this] {
        setDraws({});
        forget();
    });
    connect(&document, &Document::designChanged, this, &DesignPage::requestUpdate);
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        if (isVisible()) present();
    });
}

// Makes the controls of the study, line below line.
QWidget* DesignPage::makeQuestions() {
    auto* questions = new QWidget(this);
    m_uncertain =
        new RangeRows(RangeUse::uncertain, tr("uncertain"), 1, mostUncertain, document().units(), this);
    m_uncertain->setObjectName(QStringLiteral("uncertain"));
    m_choices = new RangeRows(RangeUse::chosen, tr("design variables"), 0, mostChoicesOfPage,
                              document().units(), this);
    m_choices->setObjectName(QStringLiteral("choices"));
    m_aims = new AimRows(this);
    m_keepEnergy = new QCheckBox(tr("keep the energy"), this);
    m_keepEnergy->setObjectName(QStringLiteral("keepEnergy"));
    m_keepEnergy->setToolTip(
        tr("Scales the blow of every design to the present blow energy, by impulse or hammer velocity"));
    m_keepEnergy->setChecked(true);
    m_samples = new ChoiceBox(this);
    m_samples->setObjectName(QStringLiteral("samples"));
    m_samples->setAccessibleName(tr("Samples of each design"));
    for (const int samples : samplesOffered) m_samples->addItem(QString::number(samples), samples);
    m_presets = new PresetTicks(this);
    m_presets->setObjectName(QStringLiteral("presets"));
    for (RangeRows* rows : {m_uncertain, m_choices})
        connect(rows, &RangeRows::changed, this, &DesignPage::keepSetup);
    connect(m_presets, &PresetTicks::changed, this, [this] {
        excludePresetKeys();
        keepSetup();
    });
    connect(m_aims, &AimRows::changed, this, &DesignPage::keepSetup);
    connect(m_keepEnergy, &QCheckBox::toggled, this, &DesignPage::keepSetup);
    connect(m_samples, &QComboBox::currentIndexChanged, this, &DesignPage::keepSetup);
    auto* lines = new QVBoxLayout(questions);
    lines->setContentsMargins(4, 0, 4, 0);
    lines->setSpacing(2);
    for (QWidget* each : std::initializer_list<QWidget*>{m_uncertain, m_choices, m_presets, m_aims})
        lines->addWidget(each);
    return questions;
}

QWidget* DesignPage::makeDrawsLine() {
    auto* line = new QWidget(this);
    line->setObjectName(QStringLiteral("draws"));
    m_drawsText = new QLabel(line);
    m_drawsText->setWordWrap(true);
    m_drawsText->setTextFormat(Qt::PlainText);
    auto* save = new QPushButton(tr("Save draws…"), line);
    save->setObjectName(QStringLiteral("saveDraws"));
    save->setToolTip(tr("Writes the table that design --draws reads"));
    connect(save, &QPushButton::clicked, this, [this] {
        PageExport wanted;
        wanted.fileStem = drawsStem;
        wanted.content = PageExport::Content::wholeFile;
        wanted.csv = [table = m_draws->table] { return table; };
        emit exportRequested(wanted);
    });
    auto* remove = new QToolButton(line);
    remove->setObjectName(QStringLiteral("removeDraws"));
    remove->setText(QStringLiteral("✕"));
    remove->setAutoRaise(true);
    remove->setAccessibleName(tr("Remove the draws"));
    remove->setToolTip(tr("Removes the draws: the uncertain rows of the settings are used again"));
    connect(remove, &QToolButton::clicked, this, [this] { setDraws({}); });
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(m_drawsText, 1);
    layout->addWidget(save);
    layout->addWidget(remove);
    line->hide();
    return line;
}

void DesignPage::takeDraws(const QString& source, const QByteArray& table) {
    std::istringstream in(table.toStdString());
    ReadDraws read = readDraws(in, source.toStdString());
    if (read.unreadable.empty() && read.invalid.empty())
        setDraws(GivenDraws{source, table, std::move(read.draws)});
}

/// The draws stand for the uncertain rows, which stay as they are in the document.
void DesignPage::setDraws(std::optional<GivenDraws> draws) {
    m_draws = std::move(draws);
    m_uncertain->setVisible(!m_draws);
    m_drawsLine->setVisible(m_draws.has_value());
    if (m_draws) {
        QStringList names;
        for (const KeptParameter& parameter : m_draws->draws.parameters) names << parameterLabel(*parameter);
        m_drawsText->setText(tr("draws of %1: %2 rows of %3")
                                 .arg(m_draws->source)
                                 .arg(m_draws->draws.rows())
                                 .arg(names.join(QStringLiteral(", "))));
    }
    requestUpdate();
}

/// Returns the file that copied commands read the draws from, which is where saving them proposes to.
QString DesignPage::drawsFile() const {
    const QFileInfo scenario(document().suggestedPath());
    const QString name = scenario.completeBaseName() + drawsStem + QStringLiteral(".csv");
    return document().path().isEmpty() ? name : QDir::toNativeSeparators(scenario.dir().filePath(name));
}

void DesignPage::copyCommand() {
    StudyPage::copyCommand();
    if (m_draws && !commandWords().isEmpty())
        m_drawsText->setText(
            tr("The copied command reads the draws from %1: save them there first.").arg(drawsFile()));
}

// Another document begins with its own set-up, or with what is proposed for it.
void DesignPage::forget() {
    m_uncertain->forget();
    m_choices->exclude({});
    m_choices->forget();
    m_aims->forget();
    m_presets->clear();
    const QSignalBlocker quiet(m_keepEnergy);
    m_keepEnergy->setChecked(true);
    m_usualSamples = 0;
    m_setup = {};
    m_isSetUp = false;
    m_refined.reset();
}

// Sets the default number of samples for the scenario, until the user chooses one.
void DesignPage::followScenario() {
    const int usual = studyPlan(scenario()).designSamples;
    if (m_usualSamples == usual) return;
    m_usualSamples = usual;
    chooseSamples(usual);
}

void DesignPage::chooseSamples(int samples) {
    const QSignalBlocker quiet(m_samples);
    if (m_samples->findData(samples) < 0) m_samples->addItem(QString::number(samples), samples);
    m_samples->setCurrentIndex(m_samples->findData(samples));
}

/// Shows the set-up of the document; for an empty one, the proposed controls.
void DesignPage::showSetup(const DesignSetup& setup) {
    if (setup.isEmpty()) {
        forget();
        m_uncertain->present(scenario());
        m_choices->present(scenario());
        m_aims->present(scenario());
        followScenario();
        return;
    }
    m_setup = setup;
    m_presets->clear();
    std::vector<std::string> choices;
    for (const std::string& text : setup.choose)
        if (!m_presets->tick(text)) choices.push_back(text);
    m_choices->exclude({});
    m_choices->setTexts(choices);
    m_choices->exclude(m_presets->keys());
    m_uncertain->setTexts(setup.uncertain);
    std::vector<DesignAim> aims;
    for (const std::string& text : setup.aims)
        if (const ParsedAim parsed = parseAim(text); parsed.problem.isEmpty() && aims.size() < mostAims)
            aims.push_back(parsed.aim);
    const QSignalBlocker first(m_aims), second(m_keepEnergy);
    m_aims->setAims(aims.empty() ? customaryAims(scenario()) : aims);
    if (canKeepEnergy()) m_keepEnergy->setChecked(setup.keepEnergy);  // else its tick waits until it can
    const auto samples =
        setup.samples.value_or(static_cast<std::uint64_t>(studyPlan(scenario()).designSamples));
    chooseSamples(static_cast<int>(std::max(leastDesignSamples, std::bit_ceil(samples))));
}

/// Hammers have the energy of their own.
bool DesignPage::canKeepEnergy() const {
    return keepEnergyProblem(scenario()).isEmpty() && !m_presets->hasHammers();
}

/// Returns the set-up of the controls; limits and seed have none and stay.
DesignSetup DesignPage::setup() const {
    DesignSetup setup = m_setup;
    setup.uncertain = m_uncertain->texts();
    setup.choose = m_presets->texts();
    for (const std::string& text : m_choices->texts()) setup.choose.push_back(text);
    setup.aims.clear();
    for (const DesignAim& aim : m_aims->aims()) setup.aims.push_back(aim.name());
    setup.keepEnergy = canKeepEnergy() && m_keepEnergy->isChecked();
    setup.samples = static_cast<std::uint64_t>(m_samples->currentData().toInt());
    return setup;
}

// Stores an edit of the user in the document, and so in its file once it is saved.
void DesignPage::keepSetup() {
    if (!m_isSetUp) return requestUpdate();
    m_keepEnergy->setEnabled(canKeepEnergy());
    m_setup = setup();
    if (m_setup == document().design()) return requestUpdate();
    document().setDesign(m_setup);  // which asks
}

// A preset and a number that it sets cannot both be chosen.
void DesignPage::excludePresetKeys() {
    m_choices->exclude(m_presets->keys());
}

// Built from the words of the command, so that both have the same values.
DesignPage::Wish DesignPage::wish() const {
    DesignStudy study;
    study.base = scenario();
    QStringList problems;
    const auto tell = [&](const Message& problem) {
        if (!problem.isEmpty()) problems << translated(withTitles(problem));
    };
    const DesignSetup now = setup();
    if (m_draws) study.draws = m_draws->draws;
    for (const std::string& text : m_draws ? std::vector<std::string>() : now.uncertain) {
        ParsedUncertain parsed = parseUncertain(text);
        tell(parsed.problem);
        study.uncertain.push_back(std::move(parsed.input));
    }
    for (const std::string& text : now.choose) {
        ParsedAxis parsed = parseChoice(text, scenario(), m_presets->lookup());
        tell(parsed.problem);
        study.choices.push_back(std::move(parsed.axis));
    }
    for (const bool atMost : {true, false})
        for (const std::string& text : atMost ? now.atMost : now.atLeast) {
            ParsedLimit parsed = parseLimit(text, atMost, scenario());
            tell(parsed.problem);
            study.limits.push_back(parsed.limit);
        }
    if (!problems.isEmpty()) return {{}, problems.join(QLatin1Char('\n'))};
    study.aims = m_aims->aims();
    study.keepsEnergy = now.keepEnergy;
    study.samples = *now.samples;
    study.seed = now.seed.value_or(1);
    return {std::move(study), {}};
}

void DesignPage::ask() {
    {
        const QSignalBlocker first(m_uncertain), second(m_choices), third(m_aims);
        followScenario();
        m_uncertain->present(scenario());
        m_choices->present(scenario());
        m_presets->present(scenario());
        m_aims->present(scenario());
        if (document().design() != m_setup) showSetup(document().design());
    }
    m_isSetUp = true;
    m_keepEnergy->setEnabled(canKeepEnergy());
    Wish now = wish();
    m_problem = now.problem;
    if (!now.study) return m_study.job().cancel();
    // A study that takes minutes is solved to its end when the user wants it.
    const bool isWanted = m_refined == now.study;
    m_study.ask({std::move(*now.study), isWanted ? std::nullopt : studyPlan(scenario()).unasked});
}

void DesignPage::refine() {
    m_refined = wish().study;
    m_refine->hide();
    requestUpdate();
}

void DesignPage::showRefine(const DesignAnswer& answer) {
    m_refine->setVisible(answer.secondsLeft && m_study.job().isCurrent() &&
                         m_study.job().state() == StudyState::finished);
    if (answer.secondsLeft) m_refine->setText(tr("Refine (%1)").arg(waitText(*answer.secondsLeft, locale())));
}

ShownUnits DesignPage::shownUnitsOf(const Scenario& base) const {
    const UnitChoice& choice = document().units();
    const Scales scales = scalesOf(base);
    return hasUnits(base) ? shownUnits(choice.physicalSystem(), scales, choice.chosen())
                          : shownUnits(naturalUnits(base), scales);
}

void DesignPage::present() {
    if (!m_problem.isEmpty()) return refuse(m_problem);
    if (m_study.job().state() == StudyState::failed) return refuse(m_study.job().problem());
    const std::shared_ptr<const DesignAnswer> answer = m_study.job().value();
    if (!answer) return;
    if (!answer->problems.empty()) {
        QStringList lines;
        for (const Message& line : answer->problems) lines << translated(withTitles(line));
        return refuse(lines.join(QLatin1Char('\n')));
    }
    showRefine(*answer);
    if (!answer->hasBest()) {
        if (m_study.job().state() == StudyState::running) return;
        if (answer->secondsLeft)
            return refuse(tr("Not solved yet: this study takes more than 10 s. Press Refine to start it."));
        Message reason;
        for (const DesignSamples& design : answer->report.findings.designs)
            if (reason.isEmpty()) reason = design.reason;
        return refuse(tr("Too many samples could not be solved: %1").arg(translated(withTitles(reason))));
    }
    const ShownUnits units = shownUnitsOf(answer->report.study.base);
    if (answer != m_shown || !(units == m_shownUnits)) {
        m_shown = answer;
        m_shownUnits = units;
        draw(*answer);
    }
    const QString problem = inputProblem();
    say(problem.isEmpty() ? m_headline
                          : tr("⚠ %1\nThe page shows the answer for the value before.").arg(problem),
        m_sentence);
    showHere();
    showRuns();
}

/// Returns why text in a field of a range is not accepted; the last accepted text stays in use.
QString DesignPage::inputProblem() const {
    const QString uncertain = m_draws ? QString() : m_uncertain->problem();
    return uncertain.isEmpty() ? m_choices->problem() : uncertain;
}

void DesignPage::draw(const DesignAnswer& answer) {
    const UnitChoice& choice = document().units();
    const DesignUnits units(
        answer.report.study, m_shownUnits,
        [&choice](const Parameter& parameter) -> const Unit& { return choice.fieldUnit(parameter); },
        locale());
    const bool wasField = m_frame->field(), isFirst = m_frame->isEmpty();
    m_frame->present(
        {designFigure(answer.report, units, DesignMarks::withoutPresent), figureUnits(m_shownUnits)});
    const std::vector<StudyPanel>& panels = m_frame->figure().panels;
    const auto bars = static_cast<int>(panels[std::size_t(DesignPanel::causes)].y.names.size());
    m_plotLines = panels[1].isHidden && panels[2].isHidden
                      ? plotLinesOfOneRow
                      : std::max(plotLinesOfDesigns, plotLinesBesideBars + bars);
    m_frame->giveMeanings(*plot());
    plot()->reader().setUsual(m_frame->field() ? nullptr : m_frame->graph(0, panels.front().marked));
    if (isFirst || wasField != (m_frame->field() != nullptr)) plot()->keyPoint().offer(m_frame->keyPlaces());
    m_card->present(answer, units);
    m_headline = DesignCard::headline(answer.report, units);
    const std::optional<std::uint64_t> better = DesignCard::designToLoad(answer.report);
    m_load->setVisible(better.has_value());
    if (better) m_load->setText(tr("Load %1").arg(units.designName(*better)));
    QStringList aims;
    for (const DesignAim& aim : answer.report.study.aims) aims << aimWords(aim);
    const QStringList beside = DesignCard::besideHeadline(answer.report, units);
    m_sentence =
        (beside.isEmpty() ? QString() : beside.join(QLatin1Char(' ')) + QLatin1Char('\n')) +
        tr("Objectives: %1").arg(aims.join(QStringLiteral(", "))) + QStringLiteral(" · ") +
        (answer.isRefined()   ? tr("%1 samples of each design").arg(answer.wanted)
         : answer.secondsLeft ? tr("%1 samples of each design so far").arg(answer.report.study.samples)
                              : tr("%1 samples of each design so far, refined to %2")
                                    .arg(answer.report.study.samples)
                                    .arg(answer.wanted));
    redraw();
}

void DesignPage::refuse(const QString& why) {
    m_shown = nullptr;
    m_card->clear();
    m_load->hide();
    showNothing(why);
}

/// Uses the blow on show, which follows the hand.
void DesignPage::showHere() {
    const std::optional<QPointF> here = blow() ? placeOf(*blow()) : std::nullopt;
    m_frame->setHere(here ? std::optional(here->x()) : std::nullopt,
                     here ? std::optional(here->y()) : std::nullopt);
}

void DesignPage::showRuns() {
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!run.isShown || !run.isSolved()) continue;
        if (const auto place = placeOf(*run.blow)) marks.append({run.number, run.letter(), *place});
    }
    m_frame->setRuns(marks);
}

// Returns the place at the blow's own value of the variable, with the aimed output as it is.
std::optional<QPointF> DesignPage::placeOf(const SolvedBlow& blow) const {
    const DesignStudy& study = m_shown->report.study;
    if (study.choices.empty() || !blow.fault.isEmpty()) return {};
    if (!study.choices.back().parameter) return {};
    const Parameter& along = *study.choices.back().parameter;
    if (!along.applies(blow.scenario) || hasUnits(blow.scenario) != hasUnits(study.base)) return {};
    const std::optional<double> x = along.value(blow.scenario);
    const Output& output = *study.aims.front().output;
    std::optional<double> y = output.value({blow.summary, blow.scenario});
    if (m_frame->field()) y = valueIn(blow.scenario, *study.choices.front().parameter);
    if (!x || !y) return {};
    // Both are multiples of scales, of which those of the blow may be others.
    const bool isScaled = !m_frame->field() && hasUnits(blow.scenario) && !output.isOnlySi();
    if (isScaled) *y *= output.scale(scalesOf(blow.scenario)) / output.scale(scalesOf(study.base));
    return QPointF(*x * m_frame->xUnit().factor, *y * m_frame->yUnit().factor);
}

/// The choices of a design, and what keeps its energy.
std::vector<ParameterValue> DesignPage::valuesOf(std::uint64_t design) const {
    std::vector<ParameterValue> values;
    if (!m_shown) return values;
    const DesignStudy& study = m_shown->report.study;
    const std::vector<double> choice = study.choice(design);
    for (std::size_t i = 0; i < choice.size(); ++i) values.push_back({study.choices[i].parameter, choice[i]});
    if (const KeptParameter scaled = energyParameter(study.base); study.keepsEnergy && scaled)
        values.push_back({scaled, *scaled->value(designScenario(study, design))});
    return values;
}

void DesignPage::click(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers) {
    if ((modifiers & ~Qt::ShiftModifier) || !m_shown || m_shown->report.study.choices.empty()) return;
    const std::optional<std::size_t> panel = m_frame->panelIn(rect);
    if (const auto design = panel ? m_frame->rowAt(coordinates, *panel) : std::nullopt)
        takeDesign(*design, modifiers);
}

/// Whether designs differ in more than numbers, so that a whole scenario is taken over.
bool DesignPage::choosesPresets() const {
    return m_shown && std::ranges::any_of(m_shown->report.study.choices,
                                          [](const SweepAxis& axis) { return !axis.parameter; });
}

void DesignPage::takeDesign(std::uint64_t design, Qt::KeyboardModifiers modifiers) {
    if (!m_shown) return;
    if (!choosesPresets()) return take(valuesOf(design), modifiers);
    const DesignStudy& study = m_shown->report.study;
    const Scenario taken = designScenario(study, design);
    if (modifiers & Qt::ShiftModifier)
        pin(taken);
    else
        load(taken, tr("take the design %1").arg(QString::fromStdString(designName(study, design))));
}

void DesignPage::loadWorst(std::size_t aim) {
    if (!m_shown || aim >= m_shown->report.findings.worst.size()) return;
    const std::optional<WorstCase>& worst = m_shown->report.findings.worst[aim];
    if (!worst) return;
    const DesignStudy& study = m_shown->report.study;
    const std::vector<ParameterValue> rock = worstInputs(study, *worst);
    const std::size_t robust = *m_shown->report.findings.best.robust;
    if (choosesPresets()) {
        Scenario scenario = designScenario(study, robust);
        for (const auto& [parameter, si] : rock) parameter->assign(scenario, si);
        return load(scenario, tr("take the worst case"));
    }
    std::vector<ParameterValue> values = valuesOf(robust);
    values.insert(values.end(), rock.begin(), rock.end());
    load(values);
}

QString DesignPage::obstacle() const {
    if (!m_problem.isEmpty()) return m_problem;
    if (QString problem = inputProblem(); !problem.isEmpty()) return problem;
    if (QString unfinished = StudyPage::obstacle(); !unfinished.isEmpty()) return unfinished;
    return m_shown ? QString() : tr("There is no design study to report.");
}

void DesignPage::addTo(ReportStudies& studies) const {
    const std::shared_ptr<const DesignAnswer>& answer = m_study.job().value();
    const bool isFinished = m_study.job().state() == StudyState::finished && m_study.job().isCurrent();
    if (!answer || !isFinished || !answer->isRefined() || !answer->hasBest()) return;
    if (answer->report.study.base == scenario() && m_setup == document().design())
        studies.design = {answer, &answer->report};
}

QByteArray DesignPage::csv() const {
    if (!m_shown) return {};
    DesignReport report = m_shown->report;
    report.scenarioText = completeScenarioText(document().contents());
    return QByteArray::fromStdString(designsCsv(report));
}

QStringList DesignPage::commandWords() const {
    const std::optional<DesignStudy> study = wish().study;
    if (!study || !inputProblem().isEmpty()) return {};
    QStringList words{QStringLiteral("design")};
    const DesignSetup now = setup();
    const auto add = [&](const QString& option, const std::vector<std::string>& texts) {
        if (!texts.empty()) words << option;
        for (const std::string& text : texts) words << fromView(text);
    };
    if (m_draws)
        words << QStringLiteral("--draws") << drawsFile();
    else
        add(QStringLiteral("--uncertain"), now.uncertain);
    add(QStringLiteral("--choose"), now.choose);
    for (const DesignAim& aim : study->aims) words << QStringLiteral("--aim") << fromView(aim.name());
    add(QStringLiteral("--at-most"), now.atMost);
    add(QStringLiteral("--at-least"), now.atLeast);
    if (study->keepsEnergy) words << QStringLiteral("--keep-energy");
    words << QStringLiteral("--samples") << QString::number(study->samples);
    if (now.seed) words << QStringLiteral("--seed") << QString::number(*now.seed);
    return words;
}

// Returns a command that prints the results of the page; if it writes files, -o names a folder.
QString DesignPage::command() const {
    const QStringList words = commandWords();
    return words.isEmpty() ? QString() : commandText(document(), words.first(), words.mid(1));
}

}  // namespace drillwave
