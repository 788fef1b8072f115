// SPDX-License-Identifier: GPL-3.0-or-later
// Placement of labels, so that each can be read.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QRectF>
#include <QVector>
#include <functional>

namespace drillwave {

/// Text with the functions that move it to each of its possible places, the best place first.
struct PlacedLabel {
    QCPItemText* text;
    QVector<std::function<void()>> places;
};

/// Returns the rectangle of a text, in pixels of the plot.
QRectF rectOf(const QCPItemText& text);

/// Returns points along a graph as drawn, about 3 px apart, in pixels of the plot.
QVector<QPointF> pointsAlong(const QCPGraph& graph);

/// Places the labels one by one where least is lost. The cost is the area cut off by `room`, the overlap with
/// `taken` and earlier labels, and the number of covered `points`. Among equally good places the first one is
/// taken. Everything is in pixels of the plot.
void placeLabels(const QVector<PlacedLabel>& labels, const QRectF& room, QVector<QRectF> taken,
                 const QVector<QPointF>& points);

}  // namespace drillwave
