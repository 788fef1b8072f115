// SPDX-License-Identifier: GPL-3.0-or-later
// The page Accuracy: how right the numbers are, for this scenario and for the hardest ones.
#pragma once

#include <array>

#include "core/report/study.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/study_page.h"

class QPushButton;
class QTableView;
class QTabWidget;

namespace drillwave {

class FigureFrame;

enum class Proof { accuracy, stability };

/// A request for a study. A repeated one counts as new, so that run times are measured again.
struct ProofQuestion {
    Proof proof = Proof::accuracy;
    Scenario scenario;  ///< of the accuracy
    int run = 0;
    bool operator==(const ProofQuestion&) const = default;
};

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
    StudyAnswerPtr wanted() const;
    void showNothing();
    QString nameOf(QPointF place) const;
    void loadRow(std::size_t row);
    void addTable(const QString& name, const QString& title);
    QTableView& table() const;
    bool hasAll() const;
    QString sentence() const;

    QPushButton* m_run;
    QTabWidget* m_tabs;
    FigureFrame* m_frame = nullptr;
    std::array<StudyAnswerPtr, 2> m_answers;  // by Proof
    StudyAnswerPtr m_shown;
    int m_runs = 0;
    StudyRunner<ProofQuestion, StudyAnswerPtr> m_study;  // goes first: its thread works
};

}  // namespace drillwave
