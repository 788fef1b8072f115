// SPDX-License-Identifier: GPL-3.0-or-later
// Single blow from rest, used as a reference for a sequence of blows.
#pragma once

#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/numeric/estimate.h"

namespace drillwave {

/// Result of a single blow from rest without a gap, as a reference for a sequence of blows.
struct BlowAlone {
    double cor = 0;  ///< coefficient of restitution e, from the impulse on the rock over that of the hammer
    Estimate penetration;  ///< penetration that remains after the blow [m]
};

/// Returns the reference blow of a scenario with units: a single blow from rest without a gap. Empty if it
/// could not be solved.
std::optional<BlowAlone> solveBlowAlone(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
