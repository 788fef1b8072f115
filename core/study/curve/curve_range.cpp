// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_range.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

double CurveRange::at(double share) const {
    if (share <= 0) return start;
    if (share >= 1) return stop;
    const double x = spacing == Spacing::linear
                         ? start * (1 - share) + stop * share
                         : std::exp(std::log(start) * (1 - share) + std::log(stop) * share);
    return std::clamp(x, start, stop);
}

double CurveRange::shareOf(double value) const {
    const double share = spacing == Spacing::linear
                             ? (value - start) / (stop - start)
                             : (std::log(value) - std::log(start)) / (std::log(stop) - std::log(start));
    return std::clamp(share, 0.0, 1.0);
}

double CurveRange::slopeAt(double value) const {
    return spacing == Spacing::linear ? stop - start : value * (std::log(stop) - std::log(start));
}

}  // namespace drillwave
