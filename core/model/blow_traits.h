// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the blow of a scenario that are known before it is solved.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Whether it is followed exactly from event to event, so that e has a bound and a curve can be traced: only
/// rock, a rod and a force on it, which groups and shape describe except for the scales (theory §4). All
/// others are solved on cells, state the error of their efficiency and are sampled.
inline bool isFollowedByEvents(const Scenario& scenario) {
    return !isString(scenario);
}

/// Whether there is a list of sections, with places that count and are named.
inline bool hasSections(const Scenario& scenario) {
    return !scenario.drillString.parts.empty();
}

/// Returns whether two scenarios both have a list of sections or both have none: then they have the same
/// places, and outputs have the same scales.
inline bool areOfOneKind(const Scenario& one, const Scenario& other) {
    return hasSections(one) == hasSections(other);
}

}  // namespace drillwave
