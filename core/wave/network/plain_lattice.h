// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for drill strings with waves that are constant over each time step, as usual in other programs.
#pragma once

#include <stop_token>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Result of a blow on a drill string, computed with waves that are constant over each time step.
struct PlainBlow {
    /// Whether the blow was computed to the end time.
    bool isSolved = false;
    /// Efficiency: work on the rock as a share of the blow energy E0.
    double efficiency = 0;
    /// Impulse on the rock as a share of the hammer's momentum p0.
    double rockImpulse = 0;
    /// Largest impact force, in units of F0.
    double peakForce = 0;
    /// Work: number of time steps times number of nodes (ends of sections).
    long cells = 0;
};

/// Returns the solution of a blow with waves that are constant over each time step, and with events at ends
/// of steps only. The error is proportional to the time step. It serves for comparison and shares no code
/// with NetworkMarch. Requires problem.endTime.
PlainBlow solvePlainLattice(const Problem& problem, const CellGrid& grid, const std::stop_token& stop = {});

}  // namespace drillwave
