// SPDX-License-Identifier: GPL-3.0-or-later
// The command Report…: what `drillwave report` writes, made beside the window's work.
#pragma once

#include <QAction>

#include "core/report/blow_report.h"
#include "ui/document/document.h"
#include "ui/job/study_job.h"
#include "ui/questions/questions.h"

namespace drillwave {

class ReportWriter : public QObject {
    Q_OBJECT

  public:
    /// Document and questions must outlive the writer, whose parent `window` is.
    ReportWriter(Document& document, Questions& questions, QWidget* window);

    /// For menus and tool bars.
    QAction* action() const { return m_action; }
    /// The studies on their way to the report, which can be stopped.
    StudyActivity& activity() { return m_job; }
    /// Asks where to, and reports on the document's scenario as it is now. An earlier report that is still on
    /// its way is given up.
    void write();

  signals:
    void begun();
    /// Written, failed or stopped.
    void ended();
    /// It is there: where, in one line.
    void written(const QString& message);

  private:
    void follow();
    void draw(const BlowReport& report);
    void fail(const QString& problem);
    QString suggestion() const;

    Document& m_document;
    Questions& m_questions;
    QWidget* m_window;
    QAction* m_action;
    QString m_path;  // of the report on its way; empty without
    StudyJob<BlowReport> m_job;
};

}  // namespace drillwave
