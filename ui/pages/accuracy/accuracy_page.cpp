// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/accuracy_page.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <chrono>
#include <stdexcept>

#include "core/archive/result_scenario.h"
#include "core/numeric/available_threads.h"
#include "core/report/blow_csv.h"
#include "core/report/proof_answer.h"
#include "core/study/rows/study_plan.h"
#include "ui/pages/accuracy/proof_table.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

StudyAnswerPtr proveStability(const StudyFeed<StudyAnswerPtr>& feed) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between{500};  // two looks: each one copies all rows
    const std::vector<StabilityCase> cases = stabilityCases();
    auto last = Clock::now();
    return stabilityAnswer(
        checkStability(cases, availableThreads(), feed.stop, [&](const StabilityReport& soFar) {
            feed.tell({.done = soFar.rows.size(), .wanted = cases.size()});
            if (Clock::now() - last < between) return;
            last = Clock::now();
            StabilityReport report = soFar;
            report.stopped = true;  // rows are missing
            feed.show(stabilityAnswer(report));
        }));
}

// Away from the window's thread; shows what there is now and then.
StudyAnswerPtr prove(const ProofQuestion& question, const StudyFeed<StudyAnswerPtr>& feed) {
    constexpr std::size_t parts = 1000;  // steps of the progress bar
    feed.show(nullptr);
    if (question.proof == Proof::stability) return proveStability(feed);
    StudyAnswerPtr answer =
        studyAccuracy(question.scenario, latticeLadder(),
                      {.stop = feed.stop,
                       .progress =
                           [&](double share) {
                               feed.tell({.done = static_cast<std::size_t>(share * parts), .wanted = parts});
                           },
                       .show = feed.show});
    if (!feed.stop.stop_requested() && !answer->gap().isEmpty())
        throw std::runtime_error(translated(answer->gap()).toStdString());
    return answer;
}

}  // namespace

AccuracyPage::AccuracyPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_run(new QPushButton(this)),
      m_tabs(new QTabWidget(this)),
      m_study(&prove) {
    m_run->setObjectName(QStringLiteral("run"));
    PlotWidget* plot = arrange({m_run});
    m_frame = new FigureFrame(plot);
    useFrame(*m_frame, tr("Error against run time, or the hardest cases against their limits"));
    m_tabs->setObjectName(QStringLiteral("proofs"));
    m_tabs->setDocumentMode(true);
    addTable(QStringLiteral("accuracyTable"), tr("This scenario"));
    addTable(QStringLiteral("stabilityTable"), tr("Hard test cases (uniform rods)"));
    m_tabs->widget(1)->setToolTip(tr("The worst first; a click loads a case"));
    static_cast<QVBoxLayout*>(layout())->addWidget(m_tabs, 1);
    watch(m_study.job());
    connect(m_run, &QPushButton::clicked, this, &AccuracyPage::runOrCancel);
    connect(m_tabs, &QTabWidget::currentChanged, this, &AccuracyPage::present);
    connect(plot, &PlotWidget::placeTaken, this, [this](const QCPAxisRect*, QPointF at) {
        if (const std::optional<std::size_t> row = m_frame->rowAt(at)) loadRow(*row);
    });
}

void AccuracyPage::addTable(const QString& name, const QString& title) {
    auto* table = new QTableView(m_tabs);
    table->setObjectName(name);
    table->setAccessibleName(title);
    table->setModel(new ProofTable(table));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing() + 6);
    table->horizontalHeader()->setDefaultSectionSize(table->fontMetrics().averageCharWidth() * 13);
    for (const auto taken : {&QTableView::clicked, &QTableView::activated})
        connect(table, taken, this, [this](const QModelIndex& index) { loadRow(std::size_t(index.row())); });
    m_tabs->addTab(table, title);
}

QTableView& AccuracyPage::table() const {
    return *static_cast<QTableView*>(m_tabs->currentWidget());
}

Proof AccuracyPage::proof() const {
    return m_tabs->currentIndex() == 1 ? Proof::stability : Proof::accuracy;
}

bool AccuracyPage::isRunning() const {
    return m_study.job().state() == StudyState::running;
}

void AccuracyPage::runOrCancel() {
    if (isRunning()) return m_study.job().cancel();
    m_study.ask({.proof = proof(), .scenario = scenario(), .run = ++m_runs});
}

// Starts nothing, as only the button does; stops a study of another scenario.
void AccuracyPage::ask() {
    if (isRunning() && m_study.question()->proof == Proof::accuracy &&
        m_study.question()->scenario != scenario())
        m_study.job().cancel();
}

// Keeps the answer of each study while the other one runs.
void AccuracyPage::takeOver() {
    if (m_study.job().isCurrent()) m_answers[std::size_t(m_study.question()->proof)] = *m_study.job().value();
}

// Returns the rows so far, of the present scenario; nullptr if there are none.
StudyAnswerPtr AccuracyPage::wanted() const {
    const StudyAnswerPtr& answer = m_answers[std::size_t(proof())];
    const bool isOther = answer && proof() == Proof::accuracy && answer->scenario() != scenario();
    return answer && answer->hasRows() && !isOther ? answer : nullptr;
}

void AccuracyPage::present() {
    takeOver();
    const std::optional<int> seconds = studyPlan(scenario()).accuracySeconds;
    const QString lasts = seconds ? tr("Run (%1 s)").arg(*seconds) : tr("Run");
    m_run->setText(isRunning()                  ? tr("Cancel")
                   : proof() == Proof::accuracy ? lasts
                                                : tr("Run (%1 s)").arg(20));
    m_run->setToolTip(proof() == Proof::accuracy
                          ? tr("Solve this scenario with every method and measure errors and times")
                          : tr("Solve and check some thousand stiff and extreme cases"));
    const StudyAnswerPtr before = std::exchange(m_shown, wanted());
    if (!m_shown) {
        showNothing();
    } else if (m_shown != before) {
        const bool isFirst = m_frame->isEmpty();
        m_frame->present({m_shown->figure(0), {}});
        if (isFirst) {
            KeyPlaces places = m_frame->keyPlaces();
            places.words = [this](QPointF place) { return nameOf(place); };
            plot()->keyPoint().offer(places);
        }
        static_cast<ProofTable*>(table().model())
            ->present(proof() == Proof::accuracy ? tr("method") : tr("case"),
                      m_shown->table(LocalStyle::of(document().units())));
        // Once: then the widths are the user's.
        constexpr int letters = 30;
        if (table().columnWidth(0) == table().horizontalHeader()->defaultSectionSize())
            table().setColumnWidth(0, letters * table().fontMetrics().averageCharWidth());
        redraw();
    }
    say(sentence());
    plot()->setCurrent(hasAll());
}

void AccuracyPage::showNothing() {
    m_frame->showNothing(proof() == Proof::stability
                             ? tr("Run solves and checks some thousand stiff and extreme cases.")
                         : isRunning() ? tr("Solving with the most exact method …")
                                       : tr("Press “Run” under “Settings” to compare the errors and run "
                                            "times of all methods for this scenario."));
    static_cast<ProofTable*>(table().model())->clear();
    redraw();
}

QString AccuracyPage::sentence() const {
    if (proof() == Proof::stability)
        return tr(
            "Cases that break solvers, each with all its checks, the worst first. A click loads a case.");
    if (blow() && blow()->isSolved() && methodKey(blow()->scenario, Method::exact) != name(Method::exact))
        return tr("The efficiency of %1 is accurate to %2, the error bound of the method.")
            .arg(numberText(blow()->summary.energy.rockWork, 6, QLocale()),
                 magnitudeText(blow()->summary.efficiencyError, QLocale()));
    if (!blow() || !blow()->isSolved())
        return tr("Accuracy of the results, and the results of other methods.");
    const QLocale locale;
    return tr("e = %1 is accurate to %2, the error bound of the exact solver.")
        .arg(numberText(blow()->impact.cor, 6, locale), magnitudeText(blow()->impact.corError, locale));
}

// Name of a point of the plot.
QString AccuracyPage::nameOf(QPointF place) const {
    const std::optional<std::size_t> row = m_frame->rowAt(place);
    return row ? table().model()->index(int(*row), 0).data().toString() : QString();
}

void AccuracyPage::loadRow(std::size_t row) {
    const std::optional<Scenario> chosen = m_shown ? m_shown->scenarioOfRow(row) : std::nullopt;
    if (chosen) load(*chosen, tr("load the case %1").arg(QString::fromStdString(chosen->title)));
}

bool AccuracyPage::hasAll() const {
    return !isRunning() && m_shown && m_shown->gap().isEmpty();
}

QString AccuracyPage::obstacle() const {
    if (hasAll()) return {};
    if (isRunning()) return tr("The study is not finished yet.");
    return m_shown ? tr("The study was stopped before its end: run it again.")
                   : tr("There is nothing to write: run the study first.");
}

QByteArray AccuracyPage::csv() const {
    return QByteArray::fromStdString(
        (proof() == Proof::accuracy ? scenarioHeader(completeScenarioText(document().contents())) : "") +
        m_shown->csv(OutputUnits::dimensionless));
}

QStringList AccuracyPage::commandWords() const {
    return {QStringLiteral("accuracy")};
}

// The extreme cases are no scenario's.
QString AccuracyPage::command() const {
    return proof() == Proof::stability ? QStringLiteral("drillwave stability -o -") : StudyPage::command();
}

}  // namespace drillwave
