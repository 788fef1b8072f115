// SPDX-License-Identifier: GPL-3.0-or-later
// Events inside a cell: which of them cut the cells, and what is only rounding.
#pragma once

#include <cmath>

namespace drillwave {

/// What a cell must stay away from an event by to be taken as a whole, in its own changes: more than its
/// projection moves it.
inline constexpr double quietMargin = 1e-3;

/// A rise is too fast for a cell where its rate times the width is more than this.
inline constexpr double fastRise = 0.4;

/// Events at one point of a cell: what balances there after so many stays there.
inline constexpr int mostStanding = 4;

/// Sets coefficients to zero that are of the size of rounding.
inline void dropRounding(double* c, int count, double rounding) {
    for (int k = 0; k < count; ++k)
        if (std::abs(c[k]) <= rounding) c[k] = 0;
}

/// Which events cut the cells.
enum class CutAt {
    nothing,
    jumps,   ///< contacts whose force rises too fast for a cell
    corners  ///< whatever bends a wave: then all cells are smooth
};

/// Where in a cell to cut: the first place that counts.
struct CellJump {
    bool found = false;
    double place = 0;  ///< in the cell, 0 … 1

    /// An event at a place of the cell.
    void offer(CutAt cutAt, bool isJump, double at) {
        constexpr double nearest = 1e-9;  // nearer to its ends a cell is not cut
        if (found || at <= nearest || at >= 1 - nearest) return;
        if (cutAt == CutAt::corners || (cutAt == CutAt::jumps && isJump)) *this = {true, at};
    }
};

}  // namespace drillwave
