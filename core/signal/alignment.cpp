// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/alignment.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace drillwave {
namespace {

constexpr int steps = 2000;

/// The points at even times, by the lines between them.
std::vector<double> sampled(const TablePoints& points, double step) {
    std::vector<double> values;
    std::size_t next = 1;
    for (int i = 0; i <= steps; ++i) {
        const double time = points.front().time + i * step;
        if (time > points.back().time) break;
        while (next + 1 < points.size() && points[next].time < time) ++next;
        const TablePoint &a = points[next - 1], &b = points[next];
        values.push_back(a.force + (b.force - a.force) * ((time - a.time) / (b.time - a.time)));
    }
    return values;
}

/// Σ measured[i] computed[i + lag].
double product(const std::vector<double>& measured, const std::vector<double>& computed, int lag) {
    const int begin = std::max(0, -lag);
    const int end = std::min(static_cast<int>(measured.size()), static_cast<int>(computed.size()) - lag);
    double sum = 0;
    for (int i = begin; i < end; ++i)
        sum += measured[static_cast<std::size_t>(i)] * computed[static_cast<std::size_t>(i + lag)];
    return sum;
}

}  // namespace

double bestShift(const TablePoints& measured, const std::function<double(double time)>& computed,
                 double end) {
    assert(measured.size() >= 2 && end > 0);
    const double step = std::max(measured.back().time - measured.front().time, end) / steps;
    const std::vector<double> mine = sampled(measured, step);
    std::vector<double> theirs;
    for (int i = 0; i <= steps && i * step <= end; ++i) theirs.push_back(computed(i * step));
    int best = 0;
    double largest = 0;
    for (int lag = -static_cast<int>(mine.size()); lag <= static_cast<int>(theirs.size()); ++lag)
        if (const double now = product(mine, theirs, lag); now > largest) {
            largest = now;
            best = lag;
        }
    if (!(largest > 0)) return 0;
    const double before = product(mine, theirs, best - 1), after = product(mine, theirs, best + 1);
    const double curvature = before - 2 * largest + after;
    const double between = curvature < 0 ? (before - after) / (2 * curvature) : 0;
    return (best + std::clamp(between, -0.5, 0.5)) * step - measured.front().time;
}

}  // namespace drillwave
