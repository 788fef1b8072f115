// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice that drill strings are usually solved on: waves constant over each cell of time.
#pragma once

#include <stop_token>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Result of a blow on the plain lattice.
struct PlainBlow {
    bool isSolved = false;
    double efficiency = 0;   ///< work on the rock [E0]
    double rockImpulse = 0;  ///< [p0]
    double peakForce = 0;    ///< [F0]
    long cells = 0;          ///< times nodes
};

/// Solves with one value of a wave for each cell and events at the ends of cells: first order in the cell.
/// For comparison; shares no code with NetworkMarch. Requires an end time.
PlainBlow solvePlainLattice(const Problem& problem, const CellGrid& grid, const std::stop_token& stop = {});

}  // namespace drillwave
