// SPDX-License-Identifier: GPL-3.0-or-later
// What the thrust is wanted for.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace drillwave {

/// From the case at hand to the worst.
enum class ThrustCase {
    scenario,      ///< the blow as given
    gapQuantile,   ///< 95 % of all gaps of a period, in this rock
    rigidRock,     ///< e = 1, the usual estimate
    elasticWorst,  ///< γ = 1 at this stiffness, the worst of all gaps
};
inline constexpr std::array thrustCases{ThrustCase::scenario, ThrustCase::gapQuantile, ThrustCase::rigidRock,
                                        ThrustCase::elasticWorst};
inline constexpr std::size_t thrustCaseCount = thrustCases.size();

/// "scenario", "gap_95_percent", "rigid_rock", "elastic_worst_gap".
constexpr std::string_view name(ThrustCase which) {
    constexpr std::array<std::string_view, thrustCaseCount> names{"scenario", "gap_95_percent", "rigid_rock",
                                                                  "elastic_worst_gap"};
    return names[static_cast<std::size_t>(which)];
}

}  // namespace drillwave
