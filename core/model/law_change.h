// SPDX-License-Identifier: GPL-3.0-or-later
// A rock under another law.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// The rock with another law: what only the one before has is dropped.
BitRock withLaw(BitRock rock, RockLaw law);

/// The same rock, at first, with another law that the scenario may have: a corner without a change of slope,
/// a power of one.
BitRock proposedRock(const Scenario& scenario, RockLaw law);

}  // namespace drillwave
