// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plot_images.h"

#include <qcustomplot.h>

#include <QTextFormat>
#include <algorithm>

namespace drillwave {

const ReportPlot* PlotImages::find(const QTextFormat& format) const {
    const std::string name = format.toImageFormat().name().toStdString();
    const auto found =
        std::ranges::find_if(m_plots, [&](const ReportPlot& plot) { return plot.picture.name == name; });
    return found == m_plots.end() ? nullptr : &*found;
}

QSizeF PlotImages::intrinsicSize(QTextDocument* /*document*/, int /*position*/, const QTextFormat& format) {
    constexpr double millimetresPerInch = 25.4;
    const ReportPlot* plot = find(format);
    if (!plot) return {};
    return QSizeF(plot->paper.size.width, plot->paper.size.height) / millimetresPerInch * m_unit;
}

void PlotImages::drawObject(QPainter* painter, const QRectF& place, QTextDocument* /*document*/,
                            int /*position*/, const QTextFormat& format) {
    const ReportPlot* plot = find(format);
    if (!plot || !m_page.contains(place.center())) return;
    painter->save();
    painter->translate(place.topLeft());
    painter->scale(m_unit / layoutDpi, m_unit / layoutDpi);
    paintPlot(*plot->paper.plot, *static_cast<QCPPainter*>(painter), plot->paper.size);
    painter->restore();
}

}  // namespace drillwave
