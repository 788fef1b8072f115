// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the parameter values at which each line takes the goal.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Relative accuracy of goal positions that are solved for. It refers to the goal or to the output's
/// variation along the line, whichever is larger. An output that remains a hundred times as far from the goal
/// is taken to jump.
inline constexpr double goalAccuracy = 1e-11;

/// Maximum number of goal positions of one line that are solved for; further ones are read from the fitted
/// curve.
inline constexpr std::size_t mostSoughtPlaces = 64;

/// Computing work of a search for the goal.
struct GoalWork {
    bool stopped = false;  ///< set if the stop token ended the search; the lines then have no goal result
    std::uint64_t solves = 0;
    /// Work of all blows of the search: wave pieces, or cells of the method of drill strings.
    long effort = 0;
};

/// Sets CurveLine::goal of every line for the first column of the question; does nothing without a goal.
/// Returns the work done.
/// Each place is found on the fitted curve and then confirmed by solving a blow there. If the blow does not
/// confirm it, the bracket is narrowed until the output equals the goal or jumps across it. Brackets between
/// points of a curve that is only known at points are not narrowed.
/// The result does not depend on the number of threads `jobs` (≥ 1).
GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop);

}  // namespace drillwave
