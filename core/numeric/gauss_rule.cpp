// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/gauss_rule.h"

#include <cmath>
#include <numbers>

namespace drillwave {

namespace {

constexpr auto degree = static_cast<double>(GaussRule::count);

/// Legendre polynomial of that degree and its slope, by the three-term recurrence.
struct Legendre {
    double value;
    double slope;
};

Legendre legendre(double u) {
    double before = 1, value = u;
    for (double k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * u * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, degree * (u * value - before) / (u * u - 1)};
}

GaussRule makeRule() {
    GaussRule rule{};
    for (std::size_t i = 0; i < GaussRule::count; ++i) {
        double u = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (degree + 0.5));
        for (int step = 0; step < 5; ++step) u -= legendre(u).value / legendre(u).slope;  // Newton, quadratic
        const double slope = legendre(u).slope;
        rule.nodes[i] = (1 - u) / 2;
        rule.weights[i] = 1 / ((1 - u * u) * slope * slope);
    }
    return rule;
}

}  // namespace

const GaussRule& gaussRule() {
    static const GaussRule rule = makeRule();
    return rule;
}

}  // namespace drillwave
