// SPDX-License-Identifier: GPL-3.0-or-later
// Placement of labels, so that each can be read.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QRectF>
#include <QVector>
#include <functional>

namespace drillwave {

/// Object name of labels that have one place only. Labels of marked points must not cover them.
inline constexpr char fixedLabel[] = "fixedLabel";

/// Label of a plot with functions that move it to each of its possible places, the best place first.
/// placeLabels() chooses among them.
struct PlacedLabel {
    QCPItemText* text;
    QVector<std::function<void()>> places;
};

/// Returns the rectangle of a text, in pixels of the plot.
QRectF rectOf(const QCPItemText& text);

/// Returns points along the line of a graph as drawn, about 3 px apart, in pixels of the plot. They are used
/// to place labels where they cover no curve.
QVector<QPointF> pointsAlong(const QCPGraph& graph);

/// Moves each label, one after another, to the place that costs least. The cost grows with the area outside
/// `room`, the overlap with `taken` and earlier labels, and the number of covered `points`. If several places
/// cost the same, the first one is chosen. All coordinates are in pixels of the plot.
void placeLabels(const QVector<PlacedLabel>& labels, const QRectF& room, QVector<QRectF> taken,
                 const QVector<QPointF>& points);

}  // namespace drillwave
