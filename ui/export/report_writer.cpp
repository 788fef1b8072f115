// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_writer.h"

#include <QDir>
#include <QFileInfo>
#include <QPrinter>
#include <utility>

#include "core/archive/report_file.h"
#include "ui/document/measured_list.h"
#include "ui/document/whole_file.h"
#include "ui/export/export_place.h"
#include "ui/export/report_comparison.h"
#include "ui/export/report_export.h"
#include "ui/export/report_preview.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::size_t parts = 1000;  // of the progress

}  // namespace

ReportWriter::ReportWriter(Document& document, Questions& questions, QWidget* window)
    : QObject(window),
      m_document(document),
      m_questions(questions),
      m_window(window),
      m_action(newAction(QStringLiteral("report"), tr("&Report…"), QKeySequence(Qt::CTRL | Qt::Key_R),
                         tr("A report as HTML or PDF: inputs with their sources, results, verdict, plots and "
                            "the scenario"))),
      m_previewAction(newAction(
          QStringLiteral("previewReport"), tr("Pre&view of the report…"), QKeySequence(),
          tr("Shows the pages of the report, with project, author, customer and date in their heading"))),
      m_printAction(newAction(QStringLiteral("printReport"), tr("&Print the report…"),
                              QKeySequence(Qt::CTRL | Qt::Key_P), tr("The report on pages of A4"))) {
    connect(m_action, &QAction::triggered, this, &ReportWriter::write);
    connect(m_previewAction, &QAction::triggered, this, &ReportWriter::preview);
    connect(m_printAction, &QAction::triggered, this, &ReportWriter::print);
    connect(&m_document, &Document::scenarioChanged, this, [this] {
        if (m_preview) m_preview->setOutOfDate(true);
    });
    connect(&m_job, &StudyActivity::changed, this, &ReportWriter::follow);
}

QAction* ReportWriter::newAction(const QString& name, const QString& text, const QKeySequence& keys,
                                 const QString& toolTip) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcut(keys);
    action->setToolTip(toolTip);
    return action;
}

QString ReportWriter::suggestion() const {
    return exportSuggestion(m_document, QStringLiteral("_report.html"));
}

void ReportWriter::setRuns(RunListPtr runs) {
    m_runs = std::move(runs);
    if (m_preview) m_preview->setOutOfDate(true);
}

void ReportWriter::setMeasured(const MeasuredList& measured) {
    m_measured = &measured;
    connect(&measured, &MeasuredList::changed, this, [this] {
        if (m_preview) m_preview->setOutOfDate(true);
    });
}

void ReportWriter::write() {
    const QString path = m_questions.fileToExport(m_window, tr("Write the report"), suggestion(),
                                                  tr("Web page (*.html);;PDF (*.pdf)"));
    if (path.isEmpty()) return;
    m_failure = tr("The report has not been written.");
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("html") && ending != QLatin1String("pdf"))
        return fail(tr("%1: a report is a file that ends in .html or .pdf; choose such a name")
                        .arg(QDir::toNativeSeparators(path)));
    begin([this, path](const BlowReport& report) { writeTo(path, report); });
}

void ReportWriter::preview() {
    m_failure = tr("There is no preview of the report.");
    begin([this](const BlowReport& report) { show(report); });
}

void ReportWriter::show(const BlowReport& report) {
    const WaitCursor wait;
    if (!m_preview) {
        m_preview = new ReportPreview(m_window);
        connect(m_preview, &ReportPreview::updateRequested, this, &ReportWriter::preview);
        connect(m_preview, &ReportPreview::writeRequested, this, &ReportWriter::write);
        connect(m_preview, &ReportPreview::printRequested, this, &ReportWriter::print);
    }
    m_preview->present(report, PaperReader::of(m_document.units()));
    m_preview->show();
    m_preview->raise();
}

void ReportWriter::print() {
    const std::shared_ptr<QPrinter> printer = m_questions.printer(m_window, m_document.displayName());
    if (!printer) return;
    m_failure = tr("The report has not been printed.");
    begin([this, printer](const BlowReport& report) { printOn(*printer, report); });
}

void ReportWriter::begin(Use use) {
    m_use = std::move(use);
    m_job.submit([document = m_document.contents(), runs = m_runs,
                  studies = m_studies()](const StudyFeed<Answer>& feed) {
        const auto tell = [&](double done) { feed.tell({static_cast<std::size_t>(done * parts), parts}); };
        Answer answer{reportOn(document, feed.stop, tell), {}};
        answer.report.studies = studies;
        if (runs) answer.runs = withMargins(*runs, feed.stop);
        return answer;
    });
    emit begun();
}

void ReportWriter::follow() {
    if (!m_use || m_job.state() == StudyState::running) return;
    const Use use = std::exchange(m_use, nullptr);
    if (m_job.state() == StudyState::failed) fail(m_job.problem());
    if (m_job.state() == StudyState::finished) {
        BlowReport report = m_job.value()->report;
        if (report.blow.isSolved()) {
            report.head = rememberedHead();
            report.others = comparisonWith(m_job.value()->runs, report.blow, m_document.units());
            if (m_measured) addMeasured(report);
            use(report);
        } else {
            fail(tr("The blow could not be solved: %1").arg(translated(report.blow.impact.reason)));
        }
    }
    emit ended();
}

void ReportWriter::addMeasured(BlowReport& report) const {
    if (!hasUnits(report.blow.scenario) || !report.blow.impact.hasHistories()) return;
    report.measured = m_measured->signalList();
    report.misfits = misfitsOf(report.measured, report.blow, m_document.units());
}

void ReportWriter::writeTo(const QString& path, const BlowReport& report) {
    const WaitCursor wait;
    const std::string format = QFileInfo(path).suffix().toLower().toStdString();
    const Pictures drawn = drawReport(report, {"report", {format}, {}}, PaperReader::of(m_document.units()));
    const QString problem = drawn.problem.isEmpty()
                                ? writeWholeFile(path, QByteArray::fromStdString(drawn.files.front().bytes))
                                : drawn.problem;
    if (!problem.isEmpty()) return fail(problem);
    rememberExportFolder(path);
    emit written(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
}

void ReportWriter::printOn(QPrinter& printer, const BlowReport& report) {
    const WaitCursor wait;
    if (!printReport(report, PaperReader::of(m_document.units()), printer))
        return fail(
            tr("%1 does not accept pages; check the printer, or write the report as PDF")
                .arg(printer.printerName().isEmpty() ? printer.outputFileName() : printer.printerName()));
    emit written(tr("Printed: %1").arg(m_document.displayName()));
}

void ReportWriter::fail(const QString& problem) {
    m_questions.tell(m_window, Questions::Tone::failure, m_failure, problem);
}

}  // namespace drillwave
