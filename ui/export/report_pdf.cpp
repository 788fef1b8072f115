// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_pdf.h"

#include <qcustomplot.h>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <cmath>

#include "core/model/version.h"
#include "ui/export/plot_images.h"

namespace drillwave {
namespace {

constexpr double margin = 15;     // [mm]
constexpr double lineHeight = 7;  // of the lines above and below the text [mm]
constexpr int resolution = 1200;  // of the layout of the text [1/in]
constexpr double millimetresPerInch = 25.4;

double pixels(double millimetres) {
    return millimetres / millimetresPerInch * resolution;
}

// The same report is the same file tomorrow. The length stays, as the file counts its bytes.
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

// No heading stands at the foot of a page while what it is about is on the next one.
void keepHeadings(QTextDocument& document) {
    constexpr double foot = 1.0 / 8;  // of a page: a table of a few lines
    const QAbstractTextDocumentLayout& layout = *document.documentLayout();
    const QSizeF size = document.pageSize();
    const auto pages = [&](const QTextBlock& block) {
        return layout.blockBoundingRect(block).top() / size.height();
    };
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || !block.next().isValid()) continue;
        const double place = pages(block);
        if (std::floor(place + foot) == std::floor(place) &&
            std::floor(pages(block.next())) == std::floor(place))
            continue;
        QTextBlockFormat format = block.blockFormat();
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        QTextCursor(block).setBlockFormat(format);
        document.setPageSize(size);  // lays all of it out anew
    }
}

void drawPage(QPainter& painter, QTextDocument& document, const QSizeF& body, int page) {
    painter.save();
    painter.translate(0, pixels(lineHeight) - page * body.height());
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = QRectF(QPointF(0, page * body.height()), body);
    context.palette.setColor(QPalette::Text, Qt::black);
    painter.setClipRect(context.clip);
    document.documentLayout()->draw(&painter, context);
    painter.restore();
}

// What stands on every page.
void drawEdges(QPainter& painter, const QString& title, const QSizeF& body, int page, int pages) {
    const QRectF head(0, 0, body.width(), pixels(lineHeight));
    const QRectF foot = head.translated(0, pixels(lineHeight) + body.height());
    const QString program = QStringLiteral("Drillwave ") + QLatin1String(versionText);
    const double room = head.width() - painter.fontMetrics().horizontalAdvance(program) - pixels(5);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignTop,
                     painter.fontMetrics().elidedText(title, Qt::ElideRight, int(room)));
    painter.drawText(head, Qt::AlignRight | Qt::AlignTop, program);
    painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
                     QStringLiteral("page %1 of %2").arg(page + 1).arg(pages));
}

}  // namespace

QByteArray reportPdf(const BlowReport& report, const std::vector<ReportPlot>& plots) {
    const FixedHashSeed sameOrder;
    const QString title = QString::fromStdString(reportTitle(report));
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Drillwave"));
    writer.setResolution(resolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin, margin, margin, margin), QPageLayout::Millimeter);

    std::vector<ReportPicture> pictures;
    for (const ReportPlot& plot : plots) pictures.push_back(plot.picture);
    PlotImages images(plots, resolution);
    QFont font(PlotStyle::forPaper().font.family());
    font.setPointSizeF(7.5);
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &images);
    document.setDocumentMargin(0);
    document.setDefaultFont(font);
    document.setHtml(QString::fromStdString(reportHtml(report, pictures, ReportMedium::paper)));
    const QSizeF body(writer.width(), writer.height() - 2 * pixels(lineHeight));
    document.setPageSize(body);
    keepHeadings(document);

    QCPPainter painter;
    painter.begin(&writer);
    const int pages = document.pageCount();
    for (int page = 0; page < pages; ++page) {
        if (page > 0) writer.newPage();
        images.setPage(QRectF(QPointF(0, page * body.height()), body));
        drawPage(painter, document, body, page);
        painter.setFont(font);
        drawEdges(painter, title, body, page, pages);
    }
    painter.end();
    QByteArray bytes = buffer.data();
    removeDate(bytes);
    return bytes;
}

}  // namespace drillwave
