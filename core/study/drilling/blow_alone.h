// SPDX-License-Identifier: GPL-3.0-or-later
// The single blow that a march of many begins with.
#pragma once

#include <stop_token>

#include "core/model/scenario.h"

namespace drillwave {

/// The coefficient of restitution e of the single blow at zero gap, of a scenario with units; not a number
/// where it is not solved.
double corAtZeroGap(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
