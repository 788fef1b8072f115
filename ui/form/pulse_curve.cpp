// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/pulse_curve.h"

#include <algorithm>

#include "core/model/pulse_force.h"

namespace drillwave {
namespace {

constexpr int curvedSteps = 40;
constexpr std::size_t mostSegments = 1000;  // segments drawn one by one

void append(QPolygonF& points, const PulseSegment& segment, double end, double peak) {
    const double length = std::min(segment.length, end - segment.start);
    const int steps = segment.kind == PulseSegment::Kind::linear ? 1 : curvedSteps;
    for (int i = 0; i <= steps; ++i) {
        const double x = length * i / steps;
        points.append({segment.start + x, segment.forceAt(x) / peak});
    }
}

// Of so many points that several fall on one pixel, the lowest and the highest of each bunch.
QPolygonF thinned(const QPolygonF& points) {
    const qsizetype bunch = points.size() / static_cast<qsizetype>(mostSegments) + 1;
    if (bunch <= 2) return points;
    QPolygonF kept;
    for (qsizetype i = 0; i < points.size(); i += bunch) {
        const auto begin = points.begin() + i;
        const auto end = points.begin() + std::min(i + bunch, points.size());
        auto [low, high] =
            std::minmax_element(begin, end, [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
        if (low > high) std::swap(low, high);
        kept.append(*low);
        kept.append(*high);
    }
    return kept;
}

}  // namespace

PulseCurve::PulseCurve(const PulseForce& force) {
    if (force.segments.empty()) return;
    end = visibleForceEnd(force);
    for (const PulseSegment& segment : force.segments)
        if (segment.start < end) append(points, segment, end, force.peak);
    points = thinned(points);
}

}  // namespace drillwave
