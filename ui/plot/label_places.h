// SPDX-License-Identifier: GPL-3.0-or-later
// Places for the names of marks and lines, so that each can be read.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QRectF>
#include <QVector>
#include <functional>

namespace drillwave {

/// A text, and its possible places, the best first.
struct PlacedLabel {
    QCPItemText* text;
    QVector<std::function<void()>> places;
};

/// Returns the rect of a text, in pixels of the plot.
QRectF rectOf(const QCPItemText& text);

/// Returns points along a graph as drawn, a few pixels apart.
QVector<QPointF> pointsAlong(const QCPGraph& graph);

/// Puts each label in turn where it is least cut off by `room`, does not lie on earlier ones nor on `taken`,
/// and covers fewest of the points; among equally good places the first of them.
void placeLabels(const QVector<PlacedLabel>& labels, const QRectF& room, QVector<QRectF> taken,
                 const QVector<QPointF>& points);

}  // namespace drillwave
