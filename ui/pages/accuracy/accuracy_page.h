// SPDX-License-Identifier: GPL-3.0-or-later
// The page Accuracy: errors of the computation for this scenario and for the hardest scenarios.
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

/// Study that the page Accuracy runs: accuracy of the present scenario, or stability in the hardest
/// scenarios.
enum class Proof { accuracy, stability };

/// Request for a study of the program's own accuracy or stability. A repeated request counts as new, so that
/// run times are measured again.
struct ProofQuestion {
    Proof proof = Proof::accuracy;
    Scenario scenario;  ///< scenario of the accuracy study; the stability study has its own
    /// Number of the request, so that two requests for the same study differ.
    int run = 0;
    bool operator==(const ProofQuestion&) const = default;
};

/// Page that checks the errors of the computation. A study starts only by a button. A result that belongs to
/// another scenario is not shown.
class AccuracyPage : public StudyPage {
    Q_OBJECT

  public:
    explicit AccuracyPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Accuracy"); }
    QString command() const override;
    /// Returns how many studies the page has started, for tests.
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
    std::array<StudyAnswerPtr, 2> m_answers;  // answers of both studies, indexed by Proof
    StudyAnswerPtr m_shown;
    int m_runs = 0;
    StudyRunner<ProofQuestion, StudyAnswerPtr> m_study;  // destroyed first: its thread works
};

}  // namespace drillwave
