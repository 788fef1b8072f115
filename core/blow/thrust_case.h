// SPDX-License-Identifier: GPL-3.0-or-later
// What the thrust is wanted for.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/text/enum_names.h"

namespace drillwave {

/// From the case at hand to the worst.
enum class ThrustCase {
    scenario,      ///< the blow as given
    gapQuantile,   ///< 95 % of all gaps of a period, in this rock
    rigidRock,     ///< e = 1, the usual estimate
    elasticWorst,  ///< γ = 1 at this stiffness, the worst of all gaps
};
inline constexpr auto thrustCases = allValues<ThrustCase>;
inline constexpr std::size_t thrustCaseCount = valueCount<ThrustCase>;

/// "scenario", "gap_95_percent", "rigid_rock", "elastic_worst_gap".
constexpr std::string_view name(ThrustCase which) {
    constexpr EnumNames<ThrustCase> names{{{ThrustCase::scenario, "scenario"},
                                           {ThrustCase::gapQuantile, "gap_95_percent"},
                                           {ThrustCase::rigidRock, "rigid_rock"},
                                           {ThrustCase::elasticWorst, "elastic_worst_gap"}}};
    return names[which];
}

}  // namespace drillwave
