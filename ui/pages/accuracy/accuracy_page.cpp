// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/accuracy_page.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/report/accuracy_report.h"
#include "core/report/blow_csv.h"
#include "core/report/stability_report.h"
#include "ui/pages/accuracy/proof_picture.h"
#include "ui/pages/accuracy/proof_plot.h"
#include "ui/pages/accuracy/proof_table.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"

namespace drillwave {

AccuracyPage::AccuracyPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_run(new QPushButton(this)),
      m_tabs(new QTabWidget(this)),
      m_accuracyTable(new ProofTable(this)),
      m_stabilityTable(new ProofTable(this)),
      m_study(&prove) {
    m_run->setObjectName(QStringLiteral("run"));
    PlotWidget* plot = arrange({m_run});
    m_plot = new ProofPlot(plot);
    m_plot->setNames([this](int row) { return nameOf(std::size_t(row)); });
    useFrame(*m_plot, tr("Error against run time, or the hardest cases against their limits"));
    m_tabs->setObjectName(QStringLiteral("proofs"));
    m_tabs->setDocumentMode(true);
    addTable(m_accuracyTable, QStringLiteral("accuracyTable"), tr("This scenario"));
    QTableView* cases =
        addTable(m_stabilityTable, QStringLiteral("stabilityTable"), tr("Stiff and extreme cases"));
    cases->setToolTip(tr("The worst first; a click loads a case"));
    static_cast<QVBoxLayout*>(layout())->addWidget(m_tabs, 1);
    watch(m_study.job());
    connect(m_run, &QPushButton::clicked, this, &AccuracyPage::runOrCancel);
    connect(m_tabs, &QTabWidget::currentChanged, this, &AccuracyPage::present);
    connect(plot, &PlotWidget::placeTaken, this, [this, plot](const QCPAxisRect*, QPointF at) {
        const QPointF pixel(plot->xAxis->coordToPixel(at.x()), plot->yAxis->coordToPixel(at.y()));
        if (proof() != Proof::stability || !m_stability) return;
        if (const std::optional<int> row = m_plot->rowAt(pixel)) loadCase(static_cast<std::size_t>(*row));
    });
    connect(cases, &QTableView::clicked, this,
            [this](const QModelIndex& index) { loadCase(m_stabilityTable->studyRow(index.row())); });
    connect(cases, &QTableView::activated, this,
            [this](const QModelIndex& index) { loadCase(m_stabilityTable->studyRow(index.row())); });
}

QTableView* AccuracyPage::addTable(ProofTable* model, const QString& name, const QString& title) {
    auto* table = new QTableView(m_tabs);
    table->setObjectName(name);
    table->setAccessibleName(title);
    table->setModel(model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing() + 6);
    table->horizontalHeader()->setDefaultSectionSize(table->fontMetrics().averageCharWidth() * 13);
    m_tabs->addTab(table, title);
    return table;
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

// Run by the button alone; what is measured for another scenario is of no use.
void AccuracyPage::ask() {
    if (isRunning() && m_study.question()->proof == Proof::accuracy &&
        m_study.question()->scenario != scenario())
        m_study.job().cancel();
}

// Each study keeps what it has found while the other one runs.
void AccuracyPage::takeOver() {
    const ProofAnswer* answer = m_study.value();
    if (!answer) return;
    bool& isWhole = answer->question.proof == Proof::accuracy ? m_accuracyIsWhole : m_stabilityIsWhole;
    if (std::exchange(m_taken, answer) != answer) isWhole = false;
    if (m_study.job().state() == StudyState::finished && m_study.job().isCurrent()) isWhole = true;
    if (answer->stability) m_stability = answer->stability;
    if (answer->accuracy || answer->stringAccuracy) {
        m_accuracy = answer->accuracy;
        m_stringAccuracy = answer->stringAccuracy;
        m_accuracyOf = answer->question.scenario;
    }
}

// What there is to be shown of the present scenario; nullptr for nothing.
const void* AccuracyPage::accuracyOfThis() const {
    if (m_accuracyOf != scenario()) return nullptr;
    if (m_stringAccuracy && !m_stringAccuracy->rows.empty()) return m_stringAccuracy.get();
    return m_accuracy && !m_accuracy->rows.empty() ? m_accuracy.get() : nullptr;
}

void AccuracyPage::present() {
    takeOver();
    const QString lasts =
        isFollowedByEvents(scenario()) ? tr("Run 10 s") : tr("Run");  // as long as the string is
    m_run->setText(isRunning() ? tr("Cancel") : proof() == Proof::accuracy ? lasts : tr("Run 20 s"));
    m_tabs->setTabText(1, isFollowedByEvents(scenario()) ? tr("Stiff and extreme cases")
                                                         : tr("Stiff and extreme cases of uniform rods"));
    m_run->setToolTip(proof() == Proof::accuracy
                          ? tr("Solve this scenario with every method and measure errors and times")
                          : tr("Solve and check some thousand stiff and extreme cases"));
    if (proof() == Proof::accuracy)
        presentAccuracy();
    else
        presentStability();
    say(sentence());
    plot()->setCurrent(hasAll());
}

void AccuracyPage::presentAccuracy() {
    const void* wanted = accuracyOfThis();
    if (wanted && wanted == m_shown) return;
    m_shown = wanted;
    const auto show = [this](const auto& accuracy) {
        m_plot->present(accuracyPicture(*accuracy, QLocale()));
        m_accuracyTable->present(accuracy);
        widenNames();
    };
    if (wanted && m_stringAccuracy) {
        show(m_stringAccuracy);
    } else if (wanted) {
        show(m_accuracy);
    } else {
        const QString first = isFollowedByEvents(scenario()) ? tr("Solving exactly, and in long double …")
                                                             : tr("Solving with cells half as large …");
        m_plot->showNothing(
            isRunning() ? first : tr("Run compares all methods on this scenario: error against time."));
        if (m_accuracyTable->rowCount() > 0) m_accuracyTable->clear();
    }
    redraw();
}

void AccuracyPage::presentStability() {
    const bool isThere = m_stability && !m_stability->rows.empty();
    const void* wanted = isThere ? m_stability.get() : nullptr;
    if (wanted && wanted == m_shown) return;
    m_shown = wanted;
    if (isThere) {
        m_plot->present(stabilityPicture(*m_stability, QLocale()));
        m_stabilityTable->present(m_stability);
        widenNames();
    } else {
        m_plot->showNothing(tr("Run solves and checks some thousand stiff and extreme cases."));
        if (m_stabilityTable->rowCount() > 0) m_stabilityTable->clear();
    }
    redraw();
}

// Once: then the widths are the user's.
void AccuracyPage::widenNames() {
    auto* table = qobject_cast<QTableView*>(m_tabs->currentWidget());
    constexpr int letters = 30;
    if (table->columnWidth(0) == table->horizontalHeader()->defaultSectionSize())
        table->setColumnWidth(0, letters * table->fontMetrics().averageCharWidth());
}

QString AccuracyPage::sentence() const {
    if (proof() == Proof::stability)
        return tr(
            "Cases that break solvers, each with all its checks, the worst first. A click loads a case.");
    if (blow() && blow()->isSolved() && !isFollowedByEvents(blow()->scenario))
        return tr("The efficiency of %1 is right to within %2, the error bound of the method.")
            .arg(numberText(blow()->summary.energy.rockWork, 6, QLocale()),
                 magnitudeText(blow()->summary.efficiencyError, QLocale()));
    if (!blow() || !blow()->isSolved())
        return tr("Accuracy of the results, and the results of other methods.");
    const QLocale locale;
    return tr("e = %1 is right to within %2, the error bound of the exact solver.")
        .arg(numberText(blow()->impact.cor, 6, locale), magnitudeText(blow()->impact.corError, locale));
}

// Of a point of the plot.
QString AccuracyPage::nameOf(std::size_t row) const {
    if (proof() == Proof::stability)
        return m_stability && row < m_stability->rows.size()
                   ? QString::fromStdString(m_stability->rows[row].stabilityCase.name)
                   : QString();
    if (m_stringAccuracy && row < m_stringAccuracy->rows.size()) return rowName(m_stringAccuracy->rows[row]);
    return m_accuracy && row < m_accuracy->rows.size() ? rowName(m_accuracy->rows[row]) : QString();
}

void AccuracyPage::loadCase(std::size_t row) {
    if (!m_stability || row >= m_stability->rows.size()) return;
    const StabilityCase& chosen = m_stability->rows[row].stabilityCase;
    load(scenarioOf(chosen), tr("load the case %1").arg(QString::fromStdString(chosen.name)));
}

bool AccuracyPage::hasAll() const {
    if (isRunning()) return false;
    if (proof() == Proof::stability) return m_stabilityIsWhole && m_stability && !m_stability->rows.empty();
    return m_accuracyIsWhole && accuracyOfThis();
}

QString AccuracyPage::obstacle() const {
    if (hasAll()) return {};
    if (isRunning()) return tr("The study is not finished yet.");
    return m_shown ? tr("The study was stopped before its end: run it again.")
                   : tr("There is nothing to write: run the study first.");
}

QByteArray AccuracyPage::csv() const {
    if (proof() == Proof::stability) return QByteArray::fromStdString(stabilityCsv(*m_stability));
    return QByteArray::fromStdString(
        scenarioHeader(completeScenarioText(document().contents())) +
        (m_stringAccuracy ? accuracyCsv(*m_stringAccuracy) : accuracyCsv(*m_accuracy)));
}

QStringList AccuracyPage::commandWords() const {
    return {QStringLiteral("accuracy")};
}

// The extreme cases are no scenario's.
QString AccuracyPage::command() const {
    return proof() == Proof::stability ? QStringLiteral("drillwave stability -o -") : StudyPage::command();
}

}  // namespace drillwave
