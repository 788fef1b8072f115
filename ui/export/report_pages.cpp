// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_pages.h"

#include <qcustomplot.h>

#include <QAbstractTextDocumentLayout>
#include <QPagedPaintDevice>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <cmath>

#include "core/model/version.h"
#include "ui/export/plot_images.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

constexpr double margin = 15;  // [mm]
constexpr int mostPages = 4;
constexpr double lineHeight = 7;  // of the lines above and below the text [mm]
constexpr double millimetresPerInch = 25.4;

// No heading stands at the foot of a page while what it is about is on the next one.
void keepHeadings(QTextDocument& document) {
    constexpr double foot = 1.0 / 8;  // of a page: a table of a few lines
    const QAbstractTextDocumentLayout& layout = *document.documentLayout();
    const QSizeF size = document.pageSize();
    // Of its first line: a picture goes to the next page without its block.
    const auto pages = [&](const QTextBlock& block) {
        const double line = block.layout()->lineCount() > 0 ? block.layout()->lineAt(0).y() : 0;
        return (layout.blockBoundingRect(block).top() + line) / size.height();
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

/// The text, laid out for the pages of a device.
class Pages {
  public:
    Pages(const BlowReport& report, const std::vector<ReportPlot>& plots, const ReadingStyle& style,
          QPagedPaintDevice& device)
        : m_title(QString::fromStdString(reportTitle(report, style))),
          m_device(device),
          m_images(plots, device.logicalDpiX()),
          m_font(PlotStyle::forPaper().font.family()),
          m_edge(lineHeight / millimetresPerInch * device.logicalDpiY()),
          m_body(device.width(), device.height() - 2 * m_edge) {
        std::vector<ReportPicture> pictures;
        for (const ReportPlot& plot : plots) pictures.push_back(plot.picture);
        m_font.setPointSizeF(7.5);
        m_document.documentLayout()->setPaintDevice(&device);
        m_document.documentLayout()->registerHandler(QTextFormat::ImageObject, &m_images);
        m_document.setDocumentMargin(0);
        m_document.setDefaultFont(m_font);
        // What else may be long is bounded: without the scenario it is three pages.
        for (std::size_t lines = mostPaperLines;; lines /= 2) {
            m_document.setHtml(
                QString::fromStdString(reportHtml(report, pictures, ReportMedium::paper, style, lines)));
            m_document.setPageSize(m_body);
            keepHeadings(m_document);
            if (m_document.pageCount() <= mostPages || lines == 0) return;
        }
    }

    bool draw() {
        QCPPainter painter;
        if (!painter.begin(&m_device)) return false;
        const int pages = m_document.pageCount();
        for (int page = 0; page < pages; ++page) {
            if (page > 0 && !m_device.newPage()) return false;
            drawBody(painter, page);
            drawEdges(painter, page, pages);
        }
        return painter.end();
    }

  private:
    void drawBody(QPainter& painter, int page) {
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = QRectF(QPointF(0, page * m_body.height()), m_body);
        context.palette.setColor(QPalette::Text, Qt::black);
        m_images.setPage(context.clip);
        painter.save();
        painter.translate(0, m_edge - context.clip.top());
        painter.setClipRect(context.clip);
        m_document.documentLayout()->draw(&painter, context);
        painter.restore();
    }

    // What stands on every page.
    void drawEdges(QPainter& painter, int page, int pages) const {
        painter.setFont(m_font);
        const QRectF head(0, 0, m_body.width(), m_edge);
        const QRectF foot = head.translated(0, m_edge + m_body.height());
        const QString program = QStringLiteral("Drillwave ") + QLatin1String(versionText);
        const double gap = 5 / millimetresPerInch * m_device.logicalDpiX();
        const double room = head.width() - painter.fontMetrics().horizontalAdvance(program) - gap;
        painter.drawText(head, Qt::AlignLeft | Qt::AlignTop,
                         painter.fontMetrics().elidedText(m_title, Qt::ElideRight, int(room)));
        painter.drawText(head, Qt::AlignRight | Qt::AlignTop, program);
        painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
                         drillwave::tr("page %1 of %2").arg(page + 1).arg(pages));
    }

    QString m_title;
    QPagedPaintDevice& m_device;
    PlotImages m_images;
    QFont m_font;
    double m_edge;  // height of the lines above and below the text
    QSizeF m_body;
    QTextDocument m_document;
};

}  // namespace

bool drawReportPages(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style, QPagedPaintDevice& device) {
    device.setPageMargins(QMarginsF(margin, margin, margin, margin), QPageLayout::Millimeter);
    return Pages(report, plots, style, device).draw();
}

}  // namespace drillwave
