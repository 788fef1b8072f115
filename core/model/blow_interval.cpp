// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blow_interval.h"

#include <cmath>

#include "core/model/scales.h"

namespace drillwave {

std::optional<double> roundTripsBetweenBlows(const Scenario& scenario) {
    if (!hasUnits(scenario) || !scenario.drill.blowFrequency) return std::nullopt;
    return 1 / (2 * chainProperties(scenario).transitTime * *scenario.drill.blowFrequency);
}

std::optional<int> stepOfWaves(double roundTrips) {
    constexpr double inStep = 0.1;
    const double whole = std::round(roundTrips);
    if (whole < 1 || whole >= enoughRoundTrips || std::abs(roundTrips - whole) > inStep) return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace drillwave
