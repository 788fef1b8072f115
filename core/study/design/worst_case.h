// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the worst value of an output within the ranges of the uncertain inputs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/best_design.h"
#include "core/study/design/design_problem.h"

namespace drillwave {

/// Number of search starts: the worst points found so far, each improved by a local search.
inline constexpr int worstSearches = 12;

/// Worst value found by the search. It is not guaranteed to be the worst, because kinks and cusps can hide
/// worse values from any search.
struct WorstCase {
    double value = 0;
    /// Values of the uncertain inputs that give the worst value, in the units of their distributions.
    std::vector<double> at;
    double sampled = 0;  ///< worst value of the samples only, drawn in the same ranges; for comparison
    int searches = 0;    ///< number of local searches made
    int agreeing = 0;    ///< number of local searches that ended within 1e-6 of the worst value
};

/// Search request: an output and the direction that is bad for it.
struct WorstOrder {
    std::size_t output = 0;
    Sense towards = Sense::least;  ///< direction to search in, opposite to the objective of the design
};

/// Returns the worst case of a design for each order. Empty where no point was solved, and after a stop
/// request.
/// The search tries all corners of the ranges, the problem's likely places, as many samples as the statistics
/// use, and 512 points on every face. From the worst 12 of these it starts a compass search. Its steps begin
/// at 0.05 of each range and are halved to 1e-7; other directions are tried where no coordinate improves.
/// Finally it climbs with steps that adapt to a ridge (see adapted_search.h). Rows of a table have no
/// direction and are tried in order.
std::vector<std::optional<WorstCase>> worstCases(const DesignProblem& problem, std::uint64_t design,
                                                 const std::vector<WorstOrder>& orders, std::uint64_t samples,
                                                 std::uint64_t seed, const DesignWork& work);

/// Returns the approximate number of starting points that worstCases() solves, for a number of uncertain
/// inputs and samples. The local searches are not counted.
std::uint64_t worstSolves(std::size_t uncertain, std::uint64_t samples);

}  // namespace drillwave
