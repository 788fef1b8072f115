// SPDX-License-Identifier: GPL-3.0-or-later
// The worst that can be found of an output within the ranges of the uncertain numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/best_design.h"
#include "core/study/design/design_problem.h"

namespace drillwave {

/// Number of the worst points from which to search on.
inline constexpr int worstSearches = 12;

/// Found, not guaranteed: kinks and cusps hide worst cases from any search.
struct WorstCase {
    double value = 0;
    std::vector<double> at;  ///< uncertain values
    double sampled = 0;      ///< the worst of the samples only, in the same ranges
    int searches = 0;        ///< number of searches made
    int agreeing = 0;        ///< number of searches that ended within 1e-6 of the value
};

/// Extreme to search for: of an output, opposite to an aim.
struct WorstOrder {
    std::size_t output = 0;
    Sense towards = Sense::least;  ///< the bad direction
};

/// Returns the worst case of one design, for each order; nothing where no point could be solved, and after a
/// stop. Tries all corners of the ranges, the likely places, as many samples as the statistics had, 512
/// points on every face, and goes on from the best 12 of these by a compass search: steps of 0.05 of the
/// range along each coordinate, where none leads on along others, halved to 1e-7. At its end it climbs once
/// more with steps that adapt to a ridge (adapted_search.h). Rows of draws have no direction: they are tried
/// in order.
std::vector<std::optional<WorstCase>> worstCases(const DesignProblem& problem, std::uint64_t design,
                                                 const std::vector<WorstOrder>& orders, std::uint64_t samples,
                                                 std::uint64_t seed, const DesignWork& work);

/// About how many points that solves.
std::uint64_t worstSolves(std::size_t uncertain, std::uint64_t samples);

}  // namespace drillwave
