// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_document.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextLayout>
#include <QTextTable>
#include <cmath>

#include "core/report/report_html.h"
#include "ui/plot/plot_style.h"

namespace drillwave {
namespace {

constexpr double pointSize = 7.5;

void setBreak(const QTextBlock& block, QTextFormat::PageBreakFlags policy) {
    QTextBlockFormat format = block.blockFormat();
    format.setPageBreakPolicy(policy);
    QTextCursor(block).setBlockFormat(format);
}

}  // namespace

ReportDocument::ReportDocument(const BlowReport& report, const std::vector<ReportPlot>& plots,
                               const ReadingStyle& style, QPaintDevice& device, const QSizeF& page)
    : m_font(PlotStyle::forPaper().font.family()), m_images(plots, device.logicalDpiX()) {
    std::vector<ReportPicture> pictures;
    for (const ReportPlot& plot : plots) pictures.push_back(plot.picture);
    m_font.setPointSizeF(pointSize);
    m_text.documentLayout()->setPaintDevice(&device);
    m_text.documentLayout()->registerHandler(QTextFormat::ImageObject, &m_images);
    m_text.setDocumentMargin(0);
    m_text.setDefaultFont(m_font);
    m_text.setHtml(QString::fromStdString(reportHtml(report, pictures, ReportMedium::paper, style)));
    m_text.setPageSize(page);
    keepTogether();
    saveLastPage();
}

void ReportDocument::layOut(double plotHeight, Ending place) {
    for (const int position : m_broken) setBreak(m_text.findBlock(position), QTextFormat::PageBreak_Auto);
    m_broken.clear();
    m_images.setHeight(plotHeight);
    m_text.setPageSize(m_text.pageSize());  // lays all of it out again
    if (place == Ending::ownPage) breakBefore(ending());
    keepTogether();
}

double ReportDocument::shareOfLastPage() const {
    const double end = m_text.documentLayout()->blockBoundingRect(m_text.lastBlock()).bottom();
    return end / m_text.pageSize().height() - (m_text.pageCount() - 1);
}

QTextBlock ReportDocument::ending() const {
    QTextBlock block = m_text.lastBlock();
    for (int headings = 0; headings < 2 && block != m_text.begin();) {
        block = block.previous();
        headings += block.blockFormat().headingLevel() > 0;
    }
    return block;
}

void ReportDocument::saveLastPage() {
    constexpr double enough = 0.5;  // of it
    const int pages = m_text.pageCount();
    if (pages == 1 || shareOfLastPage() >= enough) return;
    for (const double height : {0.94, 0.88, 0.82}) {
        layOut(height, Ending::inFlow);
        if (m_text.pageCount() < pages) return;
    }
    layOut(1, Ending::ownPage);
}

void ReportDocument::breakBefore(const QTextBlock& heading) {
    setBreak(heading, QTextFormat::PageBreak_AlwaysBefore);
    m_broken.push_back(heading.position());
    m_text.setPageSize(m_text.pageSize());  // lays all of it out again
}

void ReportDocument::keepTogether() {
    constexpr double foot = 1.0 / 8;  // of a page: a table of a few lines
    const QAbstractTextDocumentLayout& layout = *m_text.documentLayout();
    const QSizeF size = m_text.pageSize();
    // By the first line of a block: a picture goes to the next page without its block.
    const auto pages = [&](const QTextBlock& block) {
        const double line = block.layout()->lineCount() > 0 ? block.layout()->lineAt(0).y() : 0;
        return (layout.blockBoundingRect(block).top() + line) / size.height();
    };
    for (QTextBlock block = m_text.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || !block.next().isValid()) continue;
        const double place = pages(block);
        if (std::floor(place + foot) == std::floor(place) &&
            std::floor(pages(block.next())) == std::floor(place))
            continue;
        breakBefore(block);
    }
}

void ReportDocument::draw(QPainter& painter, int page) {
    const QSizeF size = m_text.pageSize();
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = QRectF(QPointF(0, page * size.height()), size);
    context.palette.setColor(QPalette::Text, Qt::black);
    m_images.setPage(context.clip);
    painter.save();
    painter.translate(0, -context.clip.top());
    painter.setClipRect(context.clip);
    m_text.documentLayout()->draw(&painter, context);
    painter.restore();
}

}  // namespace drillwave
