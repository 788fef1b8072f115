// SPDX-License-Identifier: GPL-3.0-or-later
// The page Accuracy: how right the numbers are, for this scenario and for the hardest ones.
#pragma once

#include "ui/job/study_job.h"
#include "ui/pages/accuracy/proof_study.h"
#include "ui/pages/study/study_page.h"

class QPushButton;
class QTableView;
class QTabWidget;

namespace drillwave {

class ProofPlot;
class ProofTable;

/// Only a button starts the two studies. A study of another scenario is not shown.
class AccuracyPage : public StudyPage {
    Q_OBJECT

  public:
    explicit AccuracyPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Accuracy"); }
    QString command() const override;
    /// How many studies were started.
    int studies() const { return m_study.started(); }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    Proof proof() const;
    bool isRunning() const;
    void runOrCancel();
    void takeOver();
    const void* accuracyOfThis() const;
    void presentAccuracy();
    void presentStability();
    QString nameOf(std::size_t row) const;
    void loadCase(std::size_t row);
    QTableView* addTable(ProofTable* model, const QString& name, const QString& title);
    void widenNames();
    bool hasAll() const;
    QString sentence() const;

    QPushButton* m_run;
    QTabWidget* m_tabs;
    ProofTable* m_accuracyTable;
    ProofTable* m_stabilityTable;
    ProofPlot* m_plot = nullptr;
    // The one or the other, of that scenario.
    std::shared_ptr<const Accuracy> m_accuracy;
    std::shared_ptr<const StringAccuracy> m_stringAccuracy;
    Scenario m_accuracyOf;
    std::shared_ptr<const StabilityReport> m_stability;
    const void* m_taken = nullptr;   // the answer taken over last
    bool m_accuracyIsWhole = false;  // no rows are missing
    bool m_stabilityIsWhole = false;
    const void* m_shown = nullptr;  // what the plot draws
    int m_runs = 0;
    StudyRunner<ProofQuestion, ProofAnswer> m_study;  // goes first: its thread works
};

}  // namespace drillwave
