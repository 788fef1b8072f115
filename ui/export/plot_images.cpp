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

Millimetres PlotImages::sizeOf(const ReportPlot& plot) const {
    constexpr double low = 60;  // [mm]: labels would not have room
    const Millimetres& size = plot.paper.size;
    return {size.width, std::max(std::min(size.height, low), m_height * size.height)};
}

QSizeF PlotImages::intrinsicSize(QTextDocument* /*document*/, int /*position*/, const QTextFormat& format) {
    constexpr double millimetresPerInch = 25.4;
    const ReportPlot* plot = find(format);
    if (!plot) return {};
    const Millimetres size = sizeOf(*plot);
    return QSizeF(size.width, size.height) / millimetresPerInch * m_unit;
}

void PlotImages::drawObject(QPainter* painter, const QRectF& place, QTextDocument* /*document*/,
                            int /*position*/, const QTextFormat& format) {
    const ReportPlot* plot = find(format);
    if (!plot || !m_page.contains(place.center())) return;
    painter->save();
    painter->translate(place.topLeft());
    painter->scale(m_unit / layoutDpi, m_unit / layoutDpi);
    paintPlot(*plot->paper.plot, *static_cast<QCPPainter*>(painter), sizeOf(*plot));
    painter->restore();
}

}  // namespace drillwave
