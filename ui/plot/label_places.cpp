// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {
namespace {

constexpr double step = 3;  // between the points along a graph [px]
// Cost of a lost square pixel, and of a covered point: words are read before lines.
constexpr double ofWords = 10, ofCut = 10, ofPoint = 3;

double area(const QRectF& rect) {
    return rect.isEmpty() ? 0 : rect.width() * rect.height();
}

double costOf(const QRectF& rect, const QRectF& room, const QVector<QRectF>& taken,
              const QVector<QPointF>& points) {
    double cost = ofCut * (area(rect) - area(rect & room));
    for (const QRectF& other : taken) cost += ofWords * area(rect & other);
    return cost + ofPoint * double(std::ranges::count_if(
                                points, [&](const QPointF& point) { return rect.contains(point); }));
}

}  // namespace

QRectF rectOf(const QCPItemText& text) {
    return QRectF(text.topLeft->pixelPosition(), text.bottomRight->pixelPosition()).normalized();
}

QVector<QPointF> pointsAlong(const QCPGraph& graph) {
    QVector<QPointF> points;
    if (!graph.visible()) return points;
    for (const QCPGraphData& data : *graph.data()) {
        const QPointF point = graph.coordsToPixels(data.key, data.value);
        if (!std::isfinite(point.y())) continue;
        const QPointF last = points.isEmpty() ? point : points.last();
        const double length = std::hypot(point.x() - last.x(), point.y() - last.y());
        // A graph far out of view needs no points in between.
        constexpr double most = 1e4;
        if (points.isEmpty() || length > most) {
            points.append(point);
            continue;
        }
        const int pieces = int(length / step);
        for (int i = 1; i <= pieces; ++i) points.append(last + (point - last) * (double(i) / pieces));
    }
    return points;
}

void placeLabels(const QVector<PlacedLabel>& labels, const QRectF& room, QVector<QRectF> taken,
                 const QVector<QPointF>& points) {
    for (const PlacedLabel& label : labels) {
        double least = std::numeric_limits<double>::infinity();
        const std::function<void()>* best = nullptr;
        for (const std::function<void()>& place : label.places) {
            place();
            const double cost = costOf(rectOf(*label.text), room, taken, points);
            if (!(cost < least)) continue;
            least = cost;
            best = &place;
        }
        if (best) (*best)();
        taken.append(rectOf(*label.text));
    }
}

}  // namespace drillwave
