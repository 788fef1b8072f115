// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the worst value of an output within the ranges of the uncertain inputs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/best_design.h"
#include "core/study/design/design_problem.h"

namespace drillwave {

/// Number of local searches for each worst case. They start from the worst points found before.
inline constexpr int worstSearches = 12;

/// Worst value of an output that the search has found. Kinks and cusps can hide worse values from any search.
struct WorstCase {
    double value = 0;
    /// Values of the uncertain inputs at which the output is worst, in the units of their distributions.
    std::vector<double> at;
    double sampled = 0;  ///< worst value of the samples only, drawn in the same ranges; for comparison
    int searches = 0;    ///< number of local searches made
    int agreeing = 0;    ///< number of local searches that ended within 1e-6 of the worst value
};

/// Search for a worst case: an output, and the direction in which its values get worse.
struct WorstOrder {
    std::size_t output = 0;
    Sense towards = Sense::least;  ///< direction to search in, opposite to the objective of the design
};

/// Returns the worst case of each output in `orders`, for one design. Empty for an output without any solved
/// point, and for all after a stop request.
/// The search starts with many points in the ranges of the uncertain inputs. They are all corners, 512 points
/// on every face, as many samples as the statistics use, and likely values. The worst 12 of these points each
/// start a compass search. Its steps begin at 0.05 of each range and are halved down to 1e-7; other
/// directions are tried if no coordinate improves. Finally it climbs with steps that adapt to a ridge (see
/// adapted_search.h). Rows of a table of correlated values have no direction, so local searches do not change
/// the row.
std::vector<std::optional<WorstCase>> worstCases(const DesignProblem& problem, std::uint64_t design,
                                                 const std::vector<WorstOrder>& orders, std::uint64_t samples,
                                                 std::uint64_t seed, const DesignWork& work);

/// Returns the approximate number of blows that worstCases() solves before its local searches, for a number
/// of uncertain inputs and of samples.
std::uint64_t worstSolves(std::size_t uncertain, std::uint64_t samples);

}  // namespace drillwave
