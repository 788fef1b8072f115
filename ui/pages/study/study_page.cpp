// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/study_page.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "core/yaml/scenario_file.h"
#include "ui/form/section_box.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/study_frame.h"
#include "ui/result/stale_veil.h"
#include "ui/text/scrolled_label.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int patienceMilliseconds = 150;      // as with a blow that is not solved yet
constexpr double mostOfWindowForWords = 0.15;  // of its height
constexpr int plotLines = 22;                  // with legend, caption and axes

}  // namespace

StudyPage::StudyPage(Document& document, QWidget* parent) : PlotPage(parent), m_document(document) {
    m_late.setSingleShot(true);
    m_late.setInterval(patienceMilliseconds);
    connect(&document, &Document::scenarioChanged, this, [this] {
        m_refusal.clear();
        requestUpdate();
    });
    connect(&document, &Document::replaced, this, &StudyPage::forget);
}

PlotWidget* StudyPage::arrange(const QList<QWidget*>& controls, QWidget* beside) {
    auto* words = new QLabel;
    words->setObjectName(QStringLiteral("words"));
    words->setWordWrap(true);
    words->setMargin(4);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_words = new ScrolledLabel(words, mostOfWindowForWords, this);

    m_settings = new SectionBox(tr("Settings"), this);
    auto* row = new FlowLayout(m_settings->content());
    for (QWidget* control : controls) row->addWidget(control);
    auto* copy = newButton(QStringLiteral("copyCommand"), tr("Copy as command line"),
                           tr("Copies the command that writes the same numbers as CSV"));
    connect(copy, &QPushButton::clicked, this, &StudyPage::copyCommand);
    row->addWidget(copy);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(makeAnswer());
    layout->addWidget(m_words);
    layout->addWidget(m_settings);
    PlotWidget* plot = makePlot();
    setLeastLines(plotLines);
    m_center = new QHBoxLayout;
    m_center->setSpacing(0);
    m_center->addWidget(plot, 3);
    layout->addLayout(m_center, 1);
    m_veil = new StaleVeil(plot);
    m_veil->cover(answerLabel());
    m_veil->cover(m_words);
    connect(&m_late, &QTimer::timeout, this, [this] { setStale(true); });
    if (beside) {
        m_center->addWidget(beside, 1);
        takeIntoAnswer(beside);
    }
    return plot;
}

QString StudyPage::answerText() const {
    QString text = PlotPage::answerText();
    if (!m_words->text().isEmpty()) text += QLatin1Char('\n') + m_words->text();
    return text;
}

void StudyPage::stackBelow(int width) {
    m_stackBelow = width;
    m_center->setStretch(0, 2);
}

void StudyPage::resizeEvent(QResizeEvent* event) {
    PlotPage::resizeEvent(event);
    foldSettings();
    if (m_stackBelow > 0)
        m_center->setDirection(width() < m_stackBelow ? QBoxLayout::BottomToTop : QBoxLayout::LeftToRight);
}

// In a low window the plot is seen first. A window that has grown shows the settings again.
void StudyPage::foldSettings() {
    constexpr int leastHeight = 680;  // [px]
    const bool isLow = window()->height() < leastHeight && canFoldSettings();
    if (isLow == m_isLow) return;
    m_isLow = isLow;
    const bool wasFolded = std::exchange(m_hasFolded, isLow && m_settings->isOpen());
    if (m_hasFolded || wasFolded) m_settings->setOpen(!isLow);
}

void StudyPage::addAbove(QWidget* widget, PartOf part) {
    auto* column = static_cast<QBoxLayout*>(layout());
    column->insertWidget(column->indexOf(m_settings), widget);
    if (part == PartOf::answer) takeIntoAnswer(widget);
}

void StudyPage::addBelow(QWidget* table) {
    layout()->addWidget(table);
    takeIntoAnswer(table);
}

void StudyPage::takeIntoAnswer(QWidget* widget) {
    m_veil->cover(widget);
    m_answer.append(widget);
}

// Links and buttons of an old answer do nothing.
void StudyPage::setStale(bool isStale) {
    if (!isStale) m_isForeign = false;
    m_veil->setOpaque(m_isForeign);
    m_veil->raise();
    m_veil->setVisible(isStale);
    for (QWidget* part : std::as_const(m_answer)) part->setEnabled(!isStale);
}

// Another scenario has come: its answers are not known yet, and those of the former one are none of it.
void StudyPage::forget() {
    for (StudyActivity* beside : std::as_const(m_beside)) beside->forget();
    if (m_activity->answers() == 0) return;
    m_late.stop();
    m_isForeign = true;
    setStale(true);
    showWords();
}

void StudyPage::watch(StudyActivity& activity) {
    m_activity = &activity;
    activity.setTimeLimit(unaskedTime);
    connect(&activity, &StudyActivity::changed, this, &StudyPage::follow);
}

void StudyPage::watchBeside(StudyActivity& activity) {
    m_beside.append(&activity);
    connect(&activity, &StudyActivity::changed, this, [this] {
        if (isVisible()) present();
    });
}

void StudyPage::setResult(const SolvedBlowPtr& blow) {
    m_blow = blow;
    if (isVisible()) present();
}

void StudyPage::setRuns(const RunListPtr& runs) {
    m_runs = runs;
    if (isVisible()) present();
}

void StudyPage::setCurrent(bool current) {
    m_inputCurrent = current;
    follow();
}

void StudyPage::requestUpdate() {
    if (isVisible())
        askNow();
    else
        m_due = true;
}

void StudyPage::askNow() {
    m_due = false;
    ask();
    follow();
}

// The page shows the job's answer, which may be of an earlier question.
void StudyPage::follow() {
    const bool answered = m_activity->isCurrent();
    const bool isNews = std::exchange(m_answers, m_activity->answers()) != m_activity->answers();
    if (answered || isNews || m_activity->state() == StudyState::failed) {
        m_late.stop();
        setStale(false);
    }
    if (!answered && m_activity->state() == StudyState::running && !m_late.isActive() && m_veil->isHidden()) {
        m_late.start();
    }
    plot()->setCurrent(m_inputCurrent && obstacle().isEmpty());
    showWords();
    if (isVisible()) present();
}

void StudyPage::showEvent(QShowEvent* event) {
    PlotPage::showEvent(event);
    if (event->spontaneous()) return;
    if (m_due)
        askNow();
    else
        present();
}

void StudyPage::hideEvent(QHideEvent* event) {
    PlotPage::hideEvent(event);
    if (event->spontaneous()) return;
    for (StudyActivity* beside : std::as_const(m_beside)) beside->cancel();
    if (m_activity->state() != StudyState::running) return;
    m_activity->cancel();
    m_due = true;
}

void StudyPage::say(const QString& answer, const QString& more) {
    m_sentence = answer;
    m_more = more;
    showWords();
}

void StudyPage::say(const QStringList& sentences) {
    say(sentences.value(0), sentences.mid(1).join(QLatin1Char(' ')));
}

void StudyPage::showNothing(const QString& why) {
    frame().showNothing(why);
    say(why);
    redraw();
}

void StudyPage::showNothingAsked(const QString& why) {
    m_late.stop();
    setStale(false);
    showNothing(why);
}

void StudyPage::showWords() {
    const QString fault = !m_refusal.isEmpty() ? m_refusal : m_activity->problem();
    const bool hasAnswer = fault.isEmpty() && !m_isForeign;
    answerLabel()->setText(!fault.isEmpty() ? QStringLiteral("⚠ ") + fault
                           : m_isForeign    ? QString()
                                            : m_sentence);
    m_words->setText(hasAnswer ? m_more : QString());
    m_words->setVisible(!m_words->text().isEmpty());
    layout()->activate();  // a sentence of more lines has its room at once
}

void StudyPage::load(const std::vector<ParameterValue>& values) {
    const int before = m_document.undoStack().index();
    m_refusal = m_document.assign(values, m_document.newGesture());
    showWords();
    if (m_document.undoStack().index() == before) return;
    QStringList taken;
    for (const auto& [parameter, si] : values)
        taken << tr("%1 set to %2").arg(parameterTitle(*parameter), shownValue(*parameter, si));
    emit valuesTaken(taken.join(QStringLiteral(", ")));
}

void StudyPage::pin(const std::vector<ParameterValue>& values) {
    ScenarioDocument contents;
    try {
        m_refusal = m_document.contentsWith(values, contents);
    } catch (const ScenarioError& error) {
        m_refusal = translated(error);
    }
    showWords();
    if (m_refusal.isEmpty()) emit pinRequested(contents);
}

template <class Take>
void StudyPage::takeStep(const Take& take, const QString& step) {
    const int before = m_document.undoStack().index();
    m_refusal = take();
    showWords();
    if (m_document.undoStack().index() != before) emit valuesTaken(step);
}

void StudyPage::load(const Scenario& scenario, const QString& step) {
    takeStep([&] { return m_document.useScenario(scenario, step); }, step);
}

void StudyPage::load(const ScenarioDocument& contents, const QString& step) {
    takeStep([&] { return m_document.useContents(contents, step); }, step);
}

void StudyPage::pin(const Scenario& scenario) {
    ScenarioDocument contents = m_document.contents();
    contents.scenario = scenario;
    m_refusal.clear();
    try {
        contents.text = writeScenario(contents);
    } catch (const ScenarioError& error) {
        m_refusal = translated(error);
    }
    showWords();
    if (m_refusal.isEmpty()) emit pinRequested(contents);
}

void StudyPage::take(const std::vector<ParameterValue>& values, Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ShiftModifier)
        pin(values);
    else
        load(values);
}

ShownUnits StudyPage::unitsFor(const Scenario& scenario) const {
    const Scales scales = scalesOf(scenario);
    return m_blow && hasUnits(scenario)
               ? shownUnits(m_blow->request.units, scales, m_blow->request.chosenUnits)
               : shownUnits(naturalUnits(scenario), scales);
}

FigureUnits StudyPage::figureUnits(const ShownUnits& units) const {
    return {units, [&choice = document().units()](const Parameter& parameter) -> const Unit& {
                return choice.fieldUnit(parameter);
            }};
}

QList<PageExport> StudyPage::exports() const {
    QList<PageExport> all = PlotPage::exports();
    PageExport& numbers = all.first();
    numbers.title = tr("&Data of this study…");
    numbers.toolTip = tr("The numbers of the study, as CSV");
    numbers.fileStem = QStringLiteral("_study");
    numbers.csv = [this] { return csv(); };
    numbers.content = PageExport::Content::wholeFile;
    for (PageExport& each : all) each.obstacle = [this] { return obstacle(); };
    return all;
}

// A stopped study has holes: the command would write other rows.
QString StudyPage::obstacle() const {
    if (m_activity->state() == StudyState::failed) return m_activity->problem();
    if (m_activity->state() == StudyState::stopped) return tr("The study was stopped before its end.");
    const bool finished = m_activity->state() == StudyState::finished && m_activity->isCurrent();
    return finished ? QString() : tr("The study is not finished yet.");
}

QString StudyPage::command() const {
    const QStringList words = commandWords();
    if (words.isEmpty()) return {};
    return commandText(m_document, words.first(),
                       words.mid(1) + QStringList{QStringLiteral("-o"), QStringLiteral("-")});
}

void StudyPage::copyCommand() {
    try {
        const QString text = command();
        if (!text.isEmpty()) QGuiApplication::clipboard()->setText(text);
    } catch (const ScenarioError& error) {
        m_refusal = translated(error);
        showWords();
    }
}

}  // namespace drillwave
