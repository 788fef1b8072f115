// SPDX-License-Identifier: GPL-3.0-or-later
// What the waves of a blow have until the next one: round trips in the rod.
#pragma once

#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

/// n_b = 1/(2 T f), round trips of a wave between two blows (T37). nullopt without units or a blow frequency.
std::optional<double> roundTripsBetweenBlows(const Scenario& scenario);

/// Waves of the last blow that are still felt, n_b < 6, meet the new one in step where n_b is within 0.1 of a
/// whole number below that, which is returned: 1 … 5 (theory §10).
std::optional<int> stepOfWaves(double roundTrips);

/// Round trips after which the waves of the last blow are not worth a remark (theory §10).
inline constexpr double enoughRoundTrips = 6;

}  // namespace drillwave
