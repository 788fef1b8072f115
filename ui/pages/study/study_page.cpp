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
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/study_frame.h"
#include "ui/result/stale_veil.h"
#include "ui/text/scrolled_label.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int patienceMilliseconds = 150;      // as with a blow that is not solved yet
constexpr double mostOfWindowForWords = 0.15;  // of its height
constexpr int plotLines = 17;                  // with legend, axes and table

}  // namespace

StudyPage::StudyPage(Document& document, QWidget* parent) : PlotPage(parent), m_document(document) {
    m_late.setSingleShot(true);
    m_late.setInterval(patienceMilliseconds);
    connect(&document, &Document::scenarioChanged, this, [this] {
        m_refusal.clear();
        askSoon();
    });
    connect(&document, &Document::replaced, this, &StudyPage::forget);
}

PlotWidget* StudyPage::arrange(const QList<QWidget*>& controls, QWidget* beside) {
    auto* row = new FlowLayout;
    for (QWidget* control : controls) row->addWidget(control);
    auto* copy = new QPushButton(tr("Copy as command line"), this);
    copy->setObjectName(QStringLiteral("copyCommand"));
    copy->setToolTip(tr("The command that writes the same numbers as CSV, for a terminal"));
    connect(copy, &QPushButton::clicked, this, &StudyPage::copyCommand);
    row->addWidget(copy);
    auto* copyAnswer = new QPushButton(tr("Copy answer"), this);
    copyAnswer->setObjectName(QStringLiteral("copyAnswer"));
    copyAnswer->setToolTip(tr("The sentence below, as text"));
    connect(copyAnswer, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(answerText()); });
    row->addWidget(copyAnswer);
    auto* words = new QLabel;
    words->setObjectName(QStringLiteral("words"));
    words->setWordWrap(true);
    words->setMargin(4);
    words->setMinimumHeight(2 * words->fontMetrics().lineSpacing() + 8);  // so that the plot does not jump
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_words = new ScrolledLabel(words, mostOfWindowForWords, this);

    PlotWidget* plot = makePlot();
    setLeastLines(plotLines);
    m_veil = new StaleVeil(plot);
    m_veil->cover(m_words);
    connect(&m_late, &QTimer::timeout, this, [this] { setStale(true); });
    m_center = new QHBoxLayout;
    m_center->setSpacing(0);
    m_center->addWidget(plot, 3);
    if (beside) {
        m_center->addWidget(beside, 1);
        m_veil->cover(beside);
        m_answer.append(beside);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(m_words);
    layout->addLayout(m_center, 1);
    return plot;
}

QString StudyPage::answerText() const {
    return m_words->text();
}

void StudyPage::stackBelow(int width) {
    m_stackBelow = width;
    m_center->setStretch(0, 2);  // of the plot; the answer has a third
}

void StudyPage::resizeEvent(QResizeEvent* event) {
    PlotPage::resizeEvent(event);
    if (m_stackBelow > 0)
        m_center->setDirection(width() < m_stackBelow ? QBoxLayout::BottomToTop : QBoxLayout::LeftToRight);
}

void StudyPage::addBelow(QWidget* table) {
    static_cast<QBoxLayout*>(layout())->addWidget(table);
    m_veil->cover(table);
    m_answer.append(table);
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

void StudyPage::askSoon() {
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

// What is shown is the job's, which may still be of an earlier question.
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

void StudyPage::say(const QString& sentence) {
    m_sentence = sentence;
    showWords();
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
    const QString problem = m_activity->problem();
    m_words->setText(!m_refusal.isEmpty() ? QStringLiteral("⚠ ") + m_refusal
                     : !problem.isEmpty() ? QStringLiteral("⚠ ") + problem
                     : m_isForeign        ? QString()
                                          : m_sentence);
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

// What was stopped has holes, and is not what the command writes.
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
