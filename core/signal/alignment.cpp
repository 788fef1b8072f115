// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/alignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace drillwave {

namespace {

constexpr int steps = 2000;

/// The points at even times from `begin` on, which is not before the first, by the lines between them.
std::vector<double> sampled(const TablePoints& points, double begin, double step) {
    std::vector<double> values;
    std::size_t next = 1;
    for (int i = 0; i <= steps; ++i) {
        const double time = begin + i * step;
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

std::optional<double> bestShift(const TablePoints& measured,
                                const std::function<double(double time)>& computed, double end) {
    assert(measured.size() >= 2 && end > 0);
    const double step = std::max(measured.back().time - measured.front().time, end) / steps;
    const std::vector<double> mine = sampled(measured, measured.front().time, step);
    std::vector<double> theirs;
    for (int i = 0; i <= steps && i * step <= end; ++i) theirs.push_back(computed(i * step));
    int best = 0;
    double largest = 0;
    for (int lag = -static_cast<int>(mine.size()); lag <= static_cast<int>(theirs.size()); ++lag)
        if (const double now = product(mine, theirs, lag); now > largest) {
            largest = now;
            best = lag;
        }
    if (!(largest > 0)) return std::nullopt;
    const double before = product(mine, theirs, best - 1), after = product(mine, theirs, best + 1);
    const double curvature = before - 2 * largest + after;
    const double between = curvature < 0 ? (before - after) / (2 * curvature) : 0;
    return (best + std::clamp(between, -0.5, 0.5)) * step - measured.front().time;
}

std::optional<Misfit> misfitOf(const TablePoints& measured, double shift,
                               const std::function<double(double time)>& computed, double end) {
    const double from = std::max(0.0, measured.front().time + shift);
    const double to = std::min(end, measured.back().time + shift);
    if (!(to > from)) return std::nullopt;
    const double step = (to - from) / steps;
    // Rounding may put the first time before the first point.
    const std::vector<double> mine = sampled(measured, std::max(from - shift, measured.front().time), step);
    Misfit misfit;
    double squares = 0, measuredPeak = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const double theirs = computed(from + static_cast<double>(i) * step);
        squares += (mine[i] - theirs) * (mine[i] - theirs);
        measuredPeak = std::max(measuredPeak, std::abs(mine[i]));
        misfit.computedPeak = std::max(misfit.computedPeak, std::abs(theirs));
    }
    misfit.rms = std::sqrt(squares / static_cast<double>(mine.size()));
    misfit.peakDifference = measuredPeak - misfit.computedPeak;
    if (const std::optional<double> best = bestShift(measured, computed, end)) misfit.lag = shift - *best;
    return misfit;
}

}  // namespace drillwave
