// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/view_statistics.h"

#include <algorithm>
#include <limits>

#include "core/numeric/brent.h"
#include "ui/plot/curve_reading.h"

namespace drillwave {

namespace {

/// Moves an extreme found among the drawn points to that of the exact function between their neighbours.
/// `sign` is 1 for the smallest value and -1 for the largest.
void refine(const QCPGraphDataContainer& points, const CurveMeaning& meaning, const ViewStatistics& range,
            double sign, double& at, double& extreme) {
    const auto point = points.findBegin(at, true);
    const auto behind = points.findEnd(at, true);
    const double from = std::max(range.begin, point->key);
    const double to = std::min(range.end, (behind - 1)->key);
    if (!(from < to)) return;
    const Minimum found = brentMinimum([&](double x) { return sign * meaning.value(x); }, from, to);
    if (!(found.value < sign * extreme)) return;
    at = found.x;
    extreme = sign * found.value;
}

}  // namespace

ViewStatistics viewStatistics(const QCPGraphDataContainer& points, const CurveMeaning& meaning,
                              QCPRange view) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    ViewStatistics found{none, none, none, none, none, none, none, none};
    if (points.isEmpty()) return found;
    const double begin = std::max(view.lower, points.constBegin()->key);
    const double end = std::min(view.upper, (points.constEnd() - 1)->key);
    if (!(begin <= end)) return found;
    const CursorReading ends = readCurve(points, meaning, begin, end);
    found.begin = begin;
    found.end = end;
    found.mean = ends.mean;
    found.integral = ends.integral;
    const auto look = [&found](double x, double y) {
        if (!(y >= found.least)) {
            found.least = y;
            found.leastAt = x;
        }
        if (!(y <= found.largest)) {
            found.largest = y;
            found.largestAt = x;
        }
    };
    look(begin, ends.yA);
    const auto behind = points.findEnd(end, false);
    for (auto point = points.findBegin(begin, false); point != behind; ++point)
        if (point->value == point->value) look(point->key, point->value);
    if (ends.yB == ends.yB) look(end, ends.yB);
    if (meaning.value && found.least < found.largest) {
        refine(points, meaning, found, 1, found.leastAt, found.least);
        refine(points, meaning, found, -1, found.largestAt, found.largest);
    }
    return found;
}

}  // namespace drillwave
