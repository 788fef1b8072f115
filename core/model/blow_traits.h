// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the blow of a scenario that are known before it is solved.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Returns whether the scenario has a uniform rod. Its blow is solved exactly from one contact event to the
/// next, such as the bit touching the rock (theory §4). The coefficient of restitution e then has an error
/// bound. Curves of results over a parameter can then consist of fitted smooth pieces instead of samples.
/// Blows on drill strings are computed in time steps, with an estimated error of the efficiency.
inline bool isFollowedByEvents(const Scenario& scenario) {
    return !isString(scenario);
}

/// Returns whether the scenario has a list of sections, so that sections can be addressed by name or number.
inline bool hasSections(const Scenario& scenario) {
    return !scenario.drillString.parts.empty();
}

/// Returns whether both scenarios have a list of sections, or neither has one. Otherwise positions along the
/// rod or string, and results in units of the scales, cannot be compared.
inline bool areOfOneKind(const Scenario& one, const Scenario& other) {
    return hasSections(one) == hasSections(other);
}

}  // namespace drillwave
