// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/axis_rect.h"

namespace drillwave {

QCPAxisRect* newAxisRect(QCustomPlot& plot, Sides sides) {
    auto* rect = new QCPAxisRect(&plot);
    rect->setupFullAxesBox(sides == Sides::linked);
    // Drawn in the order of these lines: axes() comes in another order in every run of the program.
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atTop, QCPAxis::atBottom}) {
        rect->axis(side)->setLayer(QStringLiteral("axes"));
        rect->axis(side)->grid()->setLayer(QStringLiteral("grid"));
    }
    return rect;
}

void placeItem(QCPAbstractItem& item, QCPAxisRect* rect, const QString& layer) {
    if (!layer.isEmpty()) item.setLayer(layer);
    item.setSelectable(false);
    item.setClipAxisRect(rect);
    for (QCPItemPosition* position : item.positions()) {
        position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        position->setAxisRect(rect);
        position->setType(QCPItemPosition::ptPlotCoords);
    }
}

void setAcross(QCPItemPosition& position) {
    position.setTypeX(QCPItemPosition::ptAxisRectRatio);
}

QCPItemStraightLine* addLevel(QCPAxisRect* rect, const QString& layer) {
    auto* line = addItem<QCPItemStraightLine>(rect, layer);
    for (QCPItemPosition* end : line->positions()) setAcross(*end);
    line->setVisible(false);
    return line;
}

void setLevel(QCPItemStraightLine& line, const std::optional<double>& value) {
    line.setVisible(value.has_value());
    if (!value) return;
    line.point1->setCoords(0, *value);
    line.point2->setCoords(1, *value);
}

}  // namespace drillwave
