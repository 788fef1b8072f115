// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/normal_quantile.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace drillwave {

namespace {

/// To 5e-4 (Abramowitz and Stegun 26.2.23), for 0 < u ≤ 1/2.
double roughQuantile(double u) {
    const double t = std::sqrt(-2 * std::log(u));
    return -(t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                     (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))));
}

}  // namespace

double normalShare(double x) {
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

double normalQuantile(double u) {
    assert(u > 0 && u < 1);
    if (u > 0.5) return -normalQuantile(1 - u);
    double x = roughQuantile(u);
    // Halley's steps: the error is cubed by each, so that two are enough.
    for (int step = 0; step < 2; ++step) {
        const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
        const double newton = (normalShare(x) - u) / density;
        x -= newton / (1 + x * newton / 2);
    }
    return x;
}

}  // namespace drillwave
