// SPDX-License-Identifier: GPL-3.0-or-later
// The worst that can be found of an output within the ranges of the uncertain numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/best_design.h"
#include "core/study/design/design_problem.h"

namespace drillwave {

/// How many of the worst points are searched on from.
inline constexpr int worstSearches = 12;

/// Found, not guaranteed: kinks and cusps hide worst cases from any search.
struct WorstCase {
    double value = 0;
    std::vector<double> at;  ///< uncertain values
    double sampled = 0;      ///< the worst of samples alone, in the same ranges
    int searches = 0;        ///< how many were made
    int agreeing = 0;        ///< how many ended within 1e-6 of the value
};

/// What is looked for: the extreme of an output, the opposite of an aim.
struct WorstOrder {
    std::size_t output = 0;
    Sense towards = Sense::least;  ///< which way it is bad
};

/// Of one design, for each order; nothing where no point could be solved, and after a stop. Tries all corners
/// of the ranges, the likely places, as many samples as the statistics had, 512 points on every face, and
/// goes on from the best 12 of these by a compass search: steps of 0.05 of the range along each coordinate,
/// where none leads on along others, halved to 1e-7. Where this ends it climbs once more with
/// steps that adapt to a ridge (adapted_search.h). Along rows of draws there is no way to go:
/// they are taken as they come.
std::vector<std::optional<WorstCase>> worstCases(const DesignProblem& problem, std::uint64_t design,
                                                 const std::vector<WorstOrder>& orders, std::uint64_t samples,
                                                 std::uint64_t seed, const DesignWork& work);

/// About how many points that solves.
std::uint64_t worstSolves(std::size_t uncertain, std::uint64_t samples);

}  // namespace drillwave
