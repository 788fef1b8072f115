// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_pages.h"

#include <qcustomplot.h>

#include <QPagedPaintDevice>

#include "core/model/version.h"
#include "core/report/report_html.h"
#include "ui/export/report_document.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double margin = 15;     // [mm]
constexpr double lineHeight = 7;  // of the lines above and below the text [mm]
constexpr double millimetresPerInch = 25.4;

/// The text, laid out for the pages of a device.
class Pages {
  public:
    Pages(const BlowReport& report, const std::vector<ReportPlot>& plots, const ReadingStyle& style,
          QPagedPaintDevice& device)
        : m_title(QString::fromStdString(reportTitle(report, style))),
          m_device(device),
          m_edge(lineHeight / millimetresPerInch * device.logicalDpiY()),
          m_document(report, plots, style, device, {double(device.width()), device.height() - 2 * m_edge}) {}

    bool draw() {
        QCPPainter painter;
        if (!painter.begin(&m_device)) return false;
        const int pages = m_document.text().pageCount();
        for (int page = 0; page < pages; ++page) {
            if (page > 0 && !m_device.newPage()) return false;
            painter.translate(0, m_edge);
            m_document.draw(painter, page);
            painter.translate(0, -m_edge);
            drawEdges(painter, page, pages);
        }
        return painter.end();
    }

  private:
    // Draws head and foot of a page.
    void drawEdges(QPainter& painter, int page, int pages) const {
        painter.setFont(m_document.font());
        const QRectF head(0, 0, m_document.text().pageSize().width(), m_edge);
        const QRectF foot = head.translated(0, m_edge + m_document.text().pageSize().height());
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
    double m_edge;  // height of the lines above and below the text
    ReportDocument m_document;
};

}  // namespace

bool drawReportPages(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style, QPagedPaintDevice& device) {
    device.setPageMargins(QMarginsF(margin, margin, margin, margin), QPageLayout::Millimeter);
    return Pages(report, plots, style, device).draw();
}

}  // namespace drillwave
