// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/view_statistics.h"

#include <algorithm>
#include <limits>

#include "ui/plot/curve_reading.h"

namespace drillwave {

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
    return found;
}

}  // namespace drillwave
