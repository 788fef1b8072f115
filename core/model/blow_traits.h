// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the blow of a scenario that are known before it is solved.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Returns whether the blow is solved exactly from one contact event to the next. This holds for a uniform
/// rod under a prescribed force, which the dimensionless groups and the shape of the force describe
/// (theory §4). The coefficient of restitution e then has an error bound, and curves can be traced instead of
/// sampled. Drill strings are computed in time steps, with an estimated error of the efficiency.
inline bool isFollowedByEvents(const Scenario& scenario) {
    return !isString(scenario);
}

/// Returns whether the scenario has a list of sections, so that sections can be addressed by name or number.
inline bool hasSections(const Scenario& scenario) {
    return !scenario.drillString.parts.empty();
}

/// Returns whether both scenarios have a list of sections, or neither has one. Only then can positions along
/// them, and results given as multiples of their scales, be compared.
inline bool areOfOneKind(const Scenario& one, const Scenario& other) {
    return hasSections(one) == hasSections(other);
}

}  // namespace drillwave
