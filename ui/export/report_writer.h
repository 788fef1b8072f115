// SPDX-License-Identifier: GPL-3.0-or-later
// The commands Report…, Preview and Print…: the report of `drillwave report`, in the numbers and units of the
// window, made in the background.
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
    /// Document and questions must outlive the writer, whose parent `window` is.
    ReportWriter(Document& document, Questions& questions, QWidget* window);

    /// Sets the runs to compare with in later reports.
    void setRuns(RunListPtr runs);
    /// Sets the function that returns the studies of future reports.
    void setStudies(std::function<ReportStudies()> studies) { m_studies = std::move(studies); }
    /// The signals that are laid over its curves from now on; they must outlive the writer.
    void setMeasured(const MeasuredList& measured);

    /// For menus and tool bars.
    QAction* action() const { return m_action; }
    QAction* previewAction() const { return m_previewAction; }
    QAction* printAction() const { return m_printAction; }
    /// The studies on their way to the report, which can be stopped.
    StudyActivity& activity() { return m_job; }
    /// Asks for a file, and reports on the document's present scenario. Gives up an earlier report that is
    /// not finished.
    void write();
    /// Shows its pages in a window, with fields for project, author and customer.
    void preview();
    /// Prints the report, once the printer is chosen.
    void print();

  signals:
    void begun();
    /// Written, printed, failed or stopped.
    void ended();
    /// The report is written: where, in one line.
    void written(const QString& message);

  private:
    struct Answer {
        BlowReport report;
        RunList runs;  ///< to compare with, as they were at the request
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
    RunListPtr m_runs;  // nullptr without
    const MeasuredList* m_measured = nullptr;
    std::function<ReportStudies()> m_studies = [] { return ReportStudies(); };
    Use m_use;          // of the report on its way; empty without
    QString m_failure;  // the message if there is no report
    StudyJob<Answer> m_job;
};

}  // namespace drillwave
