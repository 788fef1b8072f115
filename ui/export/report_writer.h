// SPDX-License-Identifier: GPL-3.0-or-later
// Menu commands Report…, Preview and Print…. They make the report of `drillwave report` in the background, in
// the language and units of the window.
#pragma once

#include <QAction>
#include <functional>

#include "core/report/blow_report.h"
#include "ui/document/document.h"
#include "ui/job/study_job.h"
#include "ui/questions/questions.h"
#include "ui/runs/runs.h"

namespace drillwave {

class MeasuredList;
class ReportPreview;

class ReportWriter : public QObject {
    Q_OBJECT

  public:
    /// Makes the menu commands of the report. `window` becomes the parent; document and questions must
    /// outlive the writer.
    ReportWriter(Document& document, Questions& questions, QWidget* window);

    /// Sets the pinned runs (results kept for comparison) with which later reports compare the blow.
    void setRuns(RunListPtr runs);
    /// Sets a function that returns the results of studies to include in later reports.
    void setStudies(std::function<ReportStudies()> studies) { m_studies = std::move(studies); }
    /// Sets the measured signals that later reports draw over the computed curves. The list must outlive the
    /// writer.
    void setMeasured(const MeasuredList& measured);

    /// Returns the command Report…, for menus and tool bars.
    QAction* action() const { return m_action; }
    QAction* previewAction() const { return m_previewAction; }
    QAction* printAction() const { return m_printAction; }
    /// Returns the state of the background work on the report, by which it can also be stopped.
    StudyActivity& activity() { return m_job; }
    /// Asks for a file and writes the report on the present scenario to it. Cancels an earlier report that is
    /// not finished.
    void write();
    /// Shows the pages of the report in a window, with fields for project, author and customer.
    void preview();
    /// Asks for a printer and prints the report.
    void print();

  signals:
    void begun();
    /// Emitted when the work on a report has ended: the report was written, shown or printed, or the work
    /// failed or was stopped.
    void ended();
    /// Emitted when the report is written or printed; `message` says in one line where.
    void written(const QString& message);

  private:
    struct Answer {
        BlowReport report;
        RunList runs;  ///< pinned runs to compare with, as they were when the report was requested
    };
    using Use = std::function<void(const BlowReport&)>;

    QAction* newAction(const QString& name, const QString& text, const QKeySequence& keys,
                       const QString& toolTip);
    void begin(Use use);
    void follow();
    void addMeasured(BlowReport& report) const;
    void show(const BlowReport& report);
    void writeTo(const QString& path, const BlowReport& report);
    void printOn(QPrinter& printer, const BlowReport& report);
    void fail(const QString& problem);
    QString suggestion() const;

    Document& m_document;
    Questions& m_questions;
    QWidget* m_window;
    QAction* m_action;
    QAction* m_previewAction;
    QAction* m_printAction;
    ReportPreview* m_preview = nullptr;
    RunListPtr m_runs;  // pinned runs to compare with; nullptr for none
    const MeasuredList* m_measured = nullptr;
    std::function<ReportStudies()> m_studies = [] { return ReportStudies(); };
    // Function that uses the report in progress; empty if there is none.
    Use m_use;
    QString m_failure;  // title of the message on failure
    StudyJob<Answer> m_job;
};

}  // namespace drillwave
