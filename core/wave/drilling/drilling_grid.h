// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of many blows: the fronts of all of them lie between cells (drilling §6).
#pragma once

#include <vector>

#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/cell_grid.h"

namespace drillwave {

struct DrillingGrid {
    CellGrid cells;  ///< round trips of all sections
    CellCuts cuts;   ///< where a front of a force lies inside every cell
    long cellsOfInterval = 1;

    double interval() const { return static_cast<double>(cellsOfInterval) * cells.cell; }
    /// By how much the frequency is another one, as a share of it.
    double rounding(const DrillingProblem& problem) const { return problem.interval / interval() - 1; }
    /// What a blow takes, in cells times nodes.
    double work(const DrillingProblem& problem) const {
        return static_cast<double>(cellsOfInterval) * static_cast<double>(cuts.count()) *
               static_cast<double>(problem.blow.sections.size() + 1);
    }
};

/// At least so many cells per t0. Intervals become whole cells; round trips that share no cell are rounded to
/// whole ones.
DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration);
/// The same with cells twice as large, or half as large where the round trips of a string share no larger
/// ones: what it changes is due to them alone, for the interval is the same.
DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration);

}  // namespace drillwave
