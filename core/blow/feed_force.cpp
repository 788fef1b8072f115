// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_force.h"

#include <cmath>
#include <numbers>

#include "core/model/scales.h"

namespace drillwave {

namespace {

constexpr double standardGravity = 9.80665;  // [m/s²]

/// Of degrees, exact where the hole is level or plumb.
double sineOf(double degrees) {
    return std::abs(degrees) == 90 ? std::copysign(1.0, degrees) : std::sin(degrees * std::numbers::pi / 180);
}

}  // namespace

std::optional<FeedForce> feedForceOf(const Scenario& scenario) {
    if (!scenario.drill.thrust) return std::nullopt;
    return FeedForce{.thrust = *scenario.drill.thrust, .weight = weightAlongHole(scenario)};
}

std::optional<double> weightAlongHole(const Scenario& scenario) {
    if (!hasUnits(scenario) || !scenario.drill.inclination) return std::nullopt;
    const double carried = chainProperties(scenario).mass;
    const double mass = carried + scenario.drill.machineMass.value_or(0);
    return mass * standardGravity * sineOf(*scenario.drill.inclination);
}

}  // namespace drillwave
