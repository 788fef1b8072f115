// SPDX-License-Identifier: GPL-3.0-or-later
// Where the names of marks and lines stand, so that each can be read.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QRectF>
#include <QVector>
#include <functional>

namespace drillwave {

/// A text, and how it is put to each of the places where it may stand, the best first.
struct PlacedLabel {
    QCPItemText* text;
    QVector<std::function<void()>> places;
};

/// Where a text stands, in pixels of the plot.
QRectF rectOf(const QCPItemText& text);

/// Points along a graph as it is drawn, a few pixels apart.
QVector<QPointF> pointsAlong(const QCPGraph& graph);

/// Puts each label, one after the other, where it is least cut off by `room`, does not lie on those before it
/// nor on `taken`, and covers fewest of the points; among places as good to the first of them.
void placeLabels(const QVector<PlacedLabel>& labels, const QRectF& room, QVector<QRectF> taken,
                 const QVector<QPointF>& points);

}  // namespace drillwave
