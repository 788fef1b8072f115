// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_contours.h"

#include <algorithm>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

/// Lines one after the other, with gaps between.
QVector<QCPCurveData> curveData(const Contour& contour, const MapPicture& picture) {
    QVector<QCPCurveData> data;
    for (const ContourLine& line : contour.lines) {
        if (!data.isEmpty()) data.append(QCPCurveData(double(data.size()), qQNaN(), qQNaN()));
        for (const ContourPoint& point : line)
            data.append(
                QCPCurveData(double(data.size()), point.x * picture.x.factor, point.y * picture.y.factor));
    }
    return data;
}

/// The first solid, others dashed.
QPen contourPen(const PlotStyle& style, int number) {
    QPen pen(style.text, 1.8);
    if (number % 3 == 1) pen.setDashPattern({6, 3});
    if (number % 3 == 2) pen.setDashPattern({2, 2});
    return pen;
}

/// Returns the middle of the longest line, the place of its name.
QPointF middleOf(const Contour& contour, const MapPicture& picture) {
    const auto longest = std::ranges::max_element(contour.lines, {}, &ContourLine::size);
    const ContourPoint& point = (*longest)[longest->size() / 2];
    return {point.x * picture.x.factor, point.y * picture.y.factor};
}

}  // namespace

void MapContours::present(const std::optional<MapPicture>& picture, const PlotStyle& style) {
    QCustomPlot& plot = *m_map->parentPlot();
    for (QCPCurve* line : m_lines) plot.removePlottable(line);
    for (QCPItemText* level : m_levels) plot.removeItem(level);
    m_lines.clear();
    m_levels.clear();
    if (!picture) return;
    int number = 0;
    for (const Contour& contour : picture->report->contours)
        if (!contour.lines.empty()) add(contour, number++, *picture, style);
}

void MapContours::add(const Contour& contour, int number, const MapPicture& picture, const PlotStyle& style) {
    QCPAxis* x = m_map->axis(QCPAxis::atBottom);
    QCPAxis* y = m_map->axis(QCPAxis::atLeft);
    const QVector<QCPCurveData> data = curveData(contour, picture);
    QColor halo = style.background;
    halo.setAlpha(200);
    for (const QPen& pen : {QPen(halo, 4), contourPen(style, number)}) {
        auto* line = new QCPCurve(x, y);
        line->setSelectable(QCP::stNone);
        line->setPen(pen);
        line->data()->set(data, true);
        m_lines.append(line);
    }
    auto* level = new QCPItemText(m_map->parentPlot());
    level->setSelectable(false);
    level->setClipAxisRect(m_map);
    level->position->setAxes(x, y);
    level->position->setAxisRect(m_map);
    level->position->setCoords(middleOf(contour, picture));
    level->setText(numberText(contour.level * picture.output.factor, 4, m_map->parentPlot()->locale()));
    level->setPadding(QMargins(4, 1, 4, 1));
    level->setFont(style.font);
    level->setColor(style.text);
    level->setBrush(halo);
    m_levels.append(level);
}

}  // namespace drillwave
