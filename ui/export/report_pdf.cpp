// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_pdf.h"

#include <QBuffer>
#include <QPdfWriter>

#include "core/archive/result_files.h"
#include "ui/export/report_pages.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int resolution = 1200;  // of the layout of the text [1/in]

// Makes the same report the same file tomorrow. Keeps the length, as the file counts its bytes.
void removeDate(QByteArray& pdf) {
    const qsizetype begin = pdf.indexOf("/CreationDate (D:");
    const qsizetype end = pdf.indexOf(')', begin) + 1;
    if (begin >= 0 && end > begin) pdf.replace(begin, end - begin, QByteArray(end - begin, ' '));
}

// Qt writes the fonts of a PDF in the order of a hash, which is another one in every run of the program
// unless its seed is fixed.
class FixedHashSeed {
  public:
    FixedHashSeed() { QHashSeed::setDeterministicGlobalSeed(); }
    ~FixedHashSeed() { QHashSeed::resetRandomGlobalSeed(); }
    FixedHashSeed(const FixedHashSeed&) = delete;
    FixedHashSeed& operator=(const FixedHashSeed&) = delete;
};

}  // namespace

QByteArray reportPdf(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style) {
    const FixedHashSeed sameOrder;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(reportTitle(report, style)));
    writer.setCreator(fromView(reportMark));
    writer.addFileAttachment(QStringLiteral("scenario.yaml"), QByteArray::fromStdString(report.scenarioText),
                             QStringLiteral("application/yaml"));
    writer.setResolution(resolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    drawReportPages(report, plots, style, writer);
    QByteArray bytes = buffer.data();
    removeDate(bytes);
    return bytes;
}

}  // namespace drillwave
