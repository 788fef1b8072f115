// SPDX-License-Identifier: GPL-3.0-or-later
// From a drill string in SI to the network that is solved.
#pragma once

#include "core/model/scenario.h"
#include "core/wave/network/network_problem.h"

namespace drillwave {

/// A force of 1 of the network, in F0.
inline constexpr double networkForce = 2;

/// The blow of a valid scenario of a drill string, in the units of its scales (scalesOf()): a force of 1 is
/// networkForce F0, an energy of 1 is Zr v0² t0, momenta and ways likewise.
NetworkProblem networkProblemOf(const Scenario& scenario);

}  // namespace drillwave
