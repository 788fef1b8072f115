// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/field_item.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

/// Least share of the whole scale for one side of the level. Values that hardly pass the level must not look
/// as far from it as those on the other side.
constexpr double leastSide = 0.1;
constexpr int barWidth = 14, hatchPeriod = 6;  // [px]
constexpr double filePixels = 3;               // pixels of the image in a file for each pixel of the plot
constexpr double mostPixels = 12e6;            // of the image: larger plots have coarser ones
constexpr int outside = -1;

QCPColorGradient gradientOf(const FieldColours& colours) {
    constexpr int stops = 128;
    QMap<double, QColor> map;
    for (int i = 0; i <= stops; ++i) {
        const double value = colours.least + (colours.largest - colours.least) * i / stops;
        map[double(i) / stops] = QColor::fromRgb(colours.scale().colour(colours.share(value)));
    }
    QCPColorGradient gradient;
    gradient.setColorStops(map);
    return gradient;
}

}  // namespace

double FieldColours::share(double value) const {
    if (!level) return 2 * (value - least) / (largest - least) - 1;
    const double side = leastSide * (largest - least);
    if (value < *level) return (value - *level) / std::max(*level - least, side);
    return (value - *level) / std::max(largest - *level, side);
}

const ColourScale& FieldColours::scale() const {
    return level ? ColourScale::aboutLevel() : ColourScale::ramp();
}

FieldItem::FieldItem(QCPAxisRect* rect)
    : QCPAbstractItem(rect->parentPlot()), m_rect(rect), m_bar(new QCPColorScale(rect->parentPlot())) {
    setSelectable(false);
    setClipAxisRect(rect);
    setLayer(QStringLiteral("background"));
    m_bar->setType(QCPAxis::atRight);
    m_bar->setBarWidth(barWidth);
    m_bar->setRangeDrag(false);
    m_bar->setRangeZoom(false);
    m_bar->setVisible(false);
}

void FieldItem::present(const StudyPanel& panel, double xFactor, double yFactor, double factor,
                        const QString& label) {
    m_field = panel.field;
    showBar(m_field.has_value());
    if (!m_field) return;
    m_xFactor = xFactor;
    m_yFactor = yFactor;
    const auto [least, largest] = rangeOf(*m_field->grid);
    m_colours = {least, largest, m_field->level};
    m_bar->setGradient(gradientOf(m_colours));
    m_bar->setDataRange({m_colours.least * factor, m_colours.largest * factor});
    m_bar->setLabel(label);
}

// In a column of its own, as high as the axes.
void FieldItem::showBar(bool isShown) {
    if (isShown == m_bar->visible()) return;
    auto& row = *qobject_cast<QCPLayoutGrid*>(m_rect->layout());
    m_bar->setVisible(isShown);
    m_bar->setMarginGroup(QCP::msTop | QCP::msBottom, isShown ? m_rect->marginGroup(QCP::msTop) : nullptr);
    if (isShown) {
        const int column = row.columnCount();
        row.addElement(0, column, m_bar);
        row.setColumnStretchFactor(column, 1e-3);
    } else {
        row.take(m_bar);
        row.simplify();
    }
}

void FieldItem::setStyle(const PlotStyle& style) {
    m_background = style.background.rgb();
    m_hatch = style.zeroLine.rgb();
    style.applyTo(*m_bar->axis()->axisRect());
    // Outside: inside they would be lost in the colours.
    for (QCPAxis* axis : m_rect->axes() + m_bar->axis()->axisRect()->axes()) {
        const bool isOnBar = axis->axisRect() != m_rect, isOutside = isOnBar || m_field;
        const int length = axis->tickLabels() || !isOutside ? 4 : 0;
        axis->setTickLength(isOutside ? 0 : length, isOutside ? length : 0);
        axis->setSubTickLength(isOutside ? 0 : length / 2, isOutside ? length / 2 : 0);
        if (!isOnBar && m_field) axis->grid()->setVisible(false);
    }
}

std::optional<std::size_t> FieldItem::nearest(QCPAxis::AxisType side, double coordinate) const {
    const bool isX = side == QCPAxis::atBottom;
    return nearestIndex(isX ? m_field->grid->xs() : m_field->grid->ys(),
                        m_rect->axis(side)->scaleType() == QCPAxis::stLogarithmic,
                        coordinate / (isX ? m_xFactor : m_yFactor));
}

std::optional<MapGrid::Place> FieldItem::pointAt(QPointF place) const {
    if (!m_field) return std::nullopt;
    const auto column = nearest(QCPAxis::atBottom, place.x()), row = nearest(QCPAxis::atLeft, place.y());
    return column && row ? std::optional(MapGrid::Place{*column, *row}) : std::nullopt;
}

QPointF FieldItem::placeOf(MapGrid::Place point) const {
    return {m_field->grid->xs()[point.column] * m_xFactor, m_field->grid->ys()[point.row] * m_yFactor};
}

std::vector<int> FieldItem::pointsAt(QCPAxis::AxisType side, int pixels) const {
    const QRect rect = m_rect->rect();
    const bool isX = side == QCPAxis::atBottom;
    const double first = isX ? rect.left() : rect.top();
    const double step = double(isX ? rect.width() : rect.height()) / pixels;
    std::vector<int> found(static_cast<std::size_t>(pixels));
    for (int i = 0; i < pixels; ++i) {
        const auto point = nearest(side, m_rect->axis(side)->pixelToCoord(first + (i + 0.5) * step));
        found[static_cast<std::size_t>(i)] = point ? static_cast<int>(*point) : outside;
    }
    return found;
}

QImage FieldItem::imageOf(QSize size, double ratio) const {
    const MapGrid& grid = *m_field->grid;
    const std::vector<int> columns = pointsAt(QCPAxis::atBottom, size.width());
    const std::vector<int> rows = pointsAt(QCPAxis::atLeft, size.height());
    const int period = std::max(2, static_cast<int>(std::lround(hatchPeriod * ratio)));
    const int thickness = std::max(1, period / 4);
    constexpr QRgb noColour = 0, hatched = 1;  // no colour of a map: those are opaque
    const auto colourAt = [&](int column, int row) {
        if (column == outside || row == outside) return noColour;
        const auto at = grid.standIn(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
        const double value = grid.value(at.column, at.row);
        const bool isUnsolved = std::isnan(value) && grid.isThere(at.column, at.row);
        return isUnsolved ? hatched : m_colours.scale().colour(m_colours.share(value));
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

void FieldItem::draw(QCPPainter* painter) {
    if (!m_field) return;
    const QRect rect = m_rect->rect();
    const bool forFile = painter->modes().testFlag(QCPPainter::pmNoCaching);
    double ratio = forFile ? filePixels : parentPlot()->bufferDevicePixelRatio();
    ratio = std::min(ratio, std::sqrt(mostPixels / std::max(1.0, double(rect.width()) * rect.height())));
    const QSize size(std::max(1, static_cast<int>(rect.width() * ratio)),
                     std::max(1, static_cast<int>(rect.height() * ratio)));
    painter->drawImage(QRectF(rect), imageOf(size, ratio));
}

void HaloPath::drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const {
    const QPen own = painter->pen();
    painter->setPen(m_halo);
    if (m_halo.style() != Qt::NoPen) QCPCurve::drawCurveLine(painter, lines);
    painter->setPen(own);
    QCPCurve::drawCurveLine(painter, lines);
}

}  // namespace drillwave
