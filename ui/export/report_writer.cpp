// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_writer.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "core/file/report_file.h"
#include "ui/document/whole_file.h"
#include "ui/export/export_place.h"
#include "ui/export/report_export.h"

namespace drillwave {
namespace {

constexpr std::size_t parts = 1000;  // of the progress

BlowReport answer(const ScenarioDocument& document, const StudyFeed<BlowReport>& feed) {
    return reportOn(document, feed.stop, [&](double done) {
        feed.tell({static_cast<std::size_t>(done * parts), parts});
    });
}

}  // namespace

ReportWriter::ReportWriter(Document& document, Questions& questions, QWidget* window)
    : QObject(window),
      m_document(document),
      m_questions(questions),
      m_window(window),
      m_action(new QAction(tr("&Report…"), this)) {
    m_action->setObjectName(QStringLiteral("report"));
    m_action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    m_action->setToolTip(
        tr("A page to hand over, as HTML or PDF: inputs with their sources, results, "
           "verdict, plots and the scenario"));
    connect(m_action, &QAction::triggered, this, &ReportWriter::write);
    connect(&m_job, &StudyActivity::changed, this, &ReportWriter::follow);
}

QString ReportWriter::suggestion() const {
    return exportSuggestion(m_document, QStringLiteral("_report.html"));
}

void ReportWriter::write() {
    const QString path = m_questions.fileToExport(m_window, tr("Write the report"), suggestion(),
                                                  tr("Web page (*.html);;PDF (*.pdf)"));
    if (path.isEmpty()) return;
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("html") && ending != QLatin1String("pdf"))
        return fail(tr("%1: a report is a file that ends in .html or .pdf; choose such a name")
                        .arg(QDir::toNativeSeparators(path)));
    m_path = path;
    m_job.submit([document = m_document.contents()](const StudyFeed<BlowReport>& feed) {
        return answer(document, feed);
    });
    emit begun();
}

void ReportWriter::follow() {
    if (m_path.isEmpty() || m_job.state() == StudyState::running) return;
    if (m_job.state() == StudyState::finished)
        draw(*m_job.value());
    else if (m_job.state() == StudyState::failed)
        fail(m_job.problem());
    m_path.clear();
    emit ended();
}

void ReportWriter::draw(const BlowReport& report) {
    if (!report.blow.isSolved())
        return fail(
            tr("The blow could not be solved: %1").arg(QString::fromStdString(report.blow.impact.reason)));
    const WaitCursor wait;
    const std::string format = QFileInfo(m_path).suffix().toLower().toStdString();
    const Pictures drawn = drawReport(report, {"report", {format}, {}});
    const QString problem = drawn.problem.isEmpty()
                                ? writeWholeFile(m_path, QByteArray::fromStdString(drawn.files.front().bytes))
                                : drawn.problem;
    if (!problem.isEmpty()) return fail(problem);
    rememberExportFolder(m_path);
    emit written(tr("Written: %1").arg(QDir::toNativeSeparators(m_path)));
}

void ReportWriter::fail(const QString& problem) {
    m_questions.tell(m_window, Questions::Tone::failure, tr("The report has not been written."), problem);
}

}  // namespace drillwave
