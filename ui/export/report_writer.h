// SPDX-License-Identifier: GPL-3.0-or-later
// The commands Report…, Preview and Print…: what `drillwave report` writes, in the numbers and units of the
// window, made beside its work.
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

    /// The runs that stand beside the blow in reports from now on.
    void setRuns(RunListPtr runs);
    /// Sets what returns the studies that reports contain from now on.
    void setStudies(std::function<ReportStudies()> studies) { m_studies = std::move(studies); }
    /// The signals that are laid over its curves from now on; they must outlive the writer.
    void setMeasured(const MeasuredList& measured);

    /// For menus and tool bars.
    QAction* action() const { return m_action; }
    QAction* previewAction() const { return m_previewAction; }
    QAction* printAction() const { return m_printAction; }
    /// The studies on their way to the report, which can be stopped.
    StudyActivity& activity() { return m_job; }
    /// Asks where to, and reports on the document's scenario as it is now. An earlier report that is still on
    /// its way is given up.
    void write();
    /// Shows its pages in a window, with fields for project, author and customer.
    void preview();
    /// The same on paper, once the printer is chosen.
    void print();

  signals:
    void begun();
    /// Written, printed, failed or stopped.
    void ended();
    /// It is there: where, in one line.
    void written(const QString& message);

  private:
    struct Answer {
        BlowReport report;
        RunList runs;  ///< beside it, as they were when it was asked for
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
    QString m_failure;  // what to say where there is none
    StudyJob<Answer> m_job;
};

}  // namespace drillwave
