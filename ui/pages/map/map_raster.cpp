// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_raster.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

constexpr int hatchPeriod = 6;       // [px]
constexpr double filePixels = 3;     // of the image in a file for one of the plot
constexpr double mostPixels = 12e6;  // of it: larger plots have coarser ones

constexpr int outside = -1;

}  // namespace

std::optional<std::size_t> AxisPlaces::nearest(double si) const {
    const double last = static_cast<double>(m_axis.count - 1);
    if (m_axis.count <= 1 || m_axis.start == m_axis.stop) return 0;
    const double share = m_axis.kind == SweepAxis::Kind::logarithmic
                             ? std::log(si / m_axis.start) / std::log(m_axis.stop / m_axis.start)
                             : (si - m_axis.start) / (m_axis.stop - m_axis.start);
    const double place = std::round(share * last);
    if (!(place >= 0 && place <= last)) return std::nullopt;  // NaN as well
    return static_cast<std::size_t>(place);
}

MapRaster::MapRaster(QCustomPlot* plot, QCPAxisRect* rect) : QCPAbstractItem(plot), m_rect(rect) {
    setSelectable(false);
    setClipAxisRect(rect);
}

void MapRaster::present(const MapPicture* picture) {
    m_picture.reset();
    if (!picture) return;
    m_picture = *picture;
    m_xPlaces = AxisPlaces(picture->report->study.x);
    m_yPlaces = AxisPlaces(picture->report->study.y);
    m_colours = picture->colours.scale();
}

void MapRaster::setStyle(const PlotStyle& style) {
    m_background = style.background.rgb();
    m_hatch = style.zeroLine.rgb();
}

std::vector<int> MapRaster::placesOf(const QCPAxis& axis, const AxisPlaces& places, double factor,
                                     int pixels) const {
    const bool across = axis.orientation() == Qt::Horizontal;
    const QRect rect = m_rect->rect();
    const double first = across ? rect.left() : rect.top();
    const double step = double(across ? rect.width() : rect.height()) / pixels;
    std::vector<int> found(static_cast<std::size_t>(pixels));
    for (int i = 0; i < pixels; ++i) {
        const auto place = places.nearest(axis.pixelToCoord(first + (i + 0.5) * step) / factor);
        found[static_cast<std::size_t>(i)] = place ? static_cast<int>(*place) : outside;
    }
    return found;
}

QImage MapRaster::imageOf(QSize size, double ratio) const {
    const MapGrid& grid = m_picture->grid();
    const std::vector<int> columns =
        placesOf(*m_rect->axis(QCPAxis::atBottom), m_xPlaces, m_picture->x.factor, size.width());
    const std::vector<int> rows =
        placesOf(*m_rect->axis(QCPAxis::atLeft), m_yPlaces, m_picture->y.factor, size.height());
    const int period = std::max(2, static_cast<int>(std::lround(hatchPeriod * ratio)));
    const int thickness = std::max(1, period / 4);
    constexpr QRgb noColour = 0, hatched = 1;  // no colour of a map: those are opaque
    const auto colourAt = [&](int column, int row) {
        if (column == outside || row == outside) return noColour;
        const auto at = grid.standIn(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
        const double value = grid.value(at.column, at.row);
        const bool isUnsolved = std::isnan(value) && grid.isThere(at.column, at.row);
        return isUnsolved ? hatched : m_colours.colour(m_picture->colours.share(value));
    };
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    std::vector<QRgb> colours(columns.size());  // of the present row, at its pixels
    bool hasHatches = false;
    for (std::size_t py = 0; py < rows.size(); ++py) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(static_cast<int>(py)));
        // Pixels of one row of points are alike but for hatches.
        const bool isRepeated = py > 0 && rows[py] == rows[py - 1];
        if (!isRepeated)
            for (std::size_t px = 0; px < columns.size(); ++px)
                colours[px] = px > 0 && columns[px] == columns[px - 1] ? colours[px - 1]
                                                                       : colourAt(columns[px], rows[py]);
        if (!isRepeated) hasHatches = std::ranges::find(colours, hatched) != colours.end();
        std::ranges::copy(colours, line);
        if (!hasHatches) continue;
        for (std::size_t px = 0; px < columns.size(); ++px)
            if (line[px] == hatched)
                line[px] = static_cast<int>(px + py) % period < thickness ? m_hatch : m_background;
    }
    return image;
}

void MapRaster::draw(QCPPainter* painter) {
    if (!m_picture) return;
    const QRect rect = m_rect->rect();
    const bool forFile = painter->modes().testFlag(QCPPainter::pmNoCaching);
    double ratio = forFile ? filePixels : parentPlot()->bufferDevicePixelRatio();
    ratio = std::min(ratio, std::sqrt(mostPixels / std::max(1.0, double(rect.width()) * rect.height())));
    const QSize size(std::max(1, static_cast<int>(rect.width() * ratio)),
                     std::max(1, static_cast<int>(rect.height() * ratio)));
    painter->drawImage(QRectF(rect), imageOf(size, ratio));
}

}  // namespace drillwave
