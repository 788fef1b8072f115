// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of many blows: the fronts of all of them lie between cells (drilling §6).
#pragma once

#include <optional>
#include <vector>

#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/network/cell_cuts.h"

namespace drillwave {

struct DrillingGrid {
    double cell = 0;                 ///< Δ [t0]
    std::vector<double> roundTrips;  ///< 2 T of each section in cells; not all of them need be whole
    CellCuts cuts;                   ///< where a front of a force lies inside every cell
    long cellsOfInterval = 1;
    /// Hammer and string are separate as soon as they part. Where round trips are not whole cells, the cubic
    /// that stands for a front swings around it, and may open a gap that is none: then they have to be apart
    /// for a cell.
    bool releasesAtOnce = true;

    double interval() const { return static_cast<double>(cellsOfInterval) * cell; }
    /// By how much the frequency is another one, as a share of it.
    double rounding(const DrillingProblem& problem) const { return problem.interval / interval() - 1; }
    /// The round trips of other sections in the same cells.
    void setSections(const std::vector<UniformSection>& sections);
    bool hasWholeTrips() const;
    /// A section whose round trip is less than a cell, which no march takes.
    std::optional<std::size_t> shortSection() const;
    /// What a blow takes, in cells times nodes.
    double work(const DrillingProblem& problem) const {
        return static_cast<double>(cellsOfInterval) * static_cast<double>(cuts.count()) *
               static_cast<double>(problem.blow.sections.size() + 1);
    }
};

/// At least so many cells per t0, and one in every round trip where up to eight times as many do. Intervals
/// become whole cells; round trips do where they share a cell that is not much smaller than is wanted.
DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration);
/// The same with cells twice as large, or half as large where the round trips of a string share no larger
/// ones: what it changes is due to them alone, for the interval is the same. Its hammer always separates at
/// once: so a separation shorter than a cell, which the cells decide, is part of what they change.
DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration);

}  // namespace drillwave
