// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of time that all round trips share (strings §11).
#pragma once

#include <vector>

#include "core/wave/problem.h"

namespace drillwave {

/// Round trips as whole numbers of cells.
struct CellGrid {
    double cell = 0;               ///< Δ [t0]
    std::vector<long> roundTrips;  ///< of each section: 2 T = roundTrips · Δ
    double rounding = 0;           ///< largest |2 T − roundTrips Δ| [t0]

    /// To cells of half the size.
    void halve();
};

// Both write into a grid that is there, whose memory they use again.

/// The largest cell that divides all round trips to 1e-9 of the longest. False where there is none of at
/// least `leastCell` [t0]: `grid` then is of no use.
bool shareGrid(const std::vector<UniformSection>& sections, double leastCell, CellGrid& grid);

/// Round trips rounded to whole cells of that size, at least one each.
void roundGrid(const std::vector<UniformSection>& sections, double cell, CellGrid& grid);

}  // namespace drillwave
