// SPDX-License-Identifier: GPL-3.0-or-later
// The single blow that a sequence is compared with.
#pragma once

#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/numeric/estimate.h"

namespace drillwave {

/// A single blow from rest at no gap.
struct BlowAlone {
    double cor = 0;        ///< e, from the impulse on the rock over that of the hammer
    Estimate penetration;  ///< that stays [m]
};

/// Solves a scenario with units; nothing where it is not solved.
std::optional<BlowAlone> solveBlowAlone(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
