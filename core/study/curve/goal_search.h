// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the parameter values at which each line takes the goal.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Accuracy with which the output equals the goal at a solved position. It is relative to the goal or to the
/// output's variation along the line, whichever is larger. If the output stays a hundred times as far from
/// the goal, it is taken to jump.
inline constexpr double goalAccuracy = 1e-11;

/// Maximum number of parameter values per curve at which a blow is solved to confirm that the output takes
/// the goal value. Further ones are only read from the fitted curve.
inline constexpr std::size_t mostSoughtPlaces = 64;

/// Computing work that a search for the goal has taken.
struct GoalWork {
    bool stopped = false;  ///< set if the stop token ended the search; the lines then have no goal result
    std::uint64_t solves = 0;
    /// Computing work of all blows of the search: polynomial pieces of waves, or for drill strings time steps
    /// times nodes.
    long effort = 0;
};

/// Sets CurveLine::goal of every line for the first column of the question; does nothing without a goal.
/// Returns the work done.
/// Each position is found on the fitted curve and then confirmed by solving a blow there. If the blow does
/// not confirm it, the bracket is narrowed until the output equals the goal or jumps across it. If the curve
/// is only known at points, positions between two points are not narrowed further.
/// The result does not depend on the number of threads `jobs` (≥ 1).
GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop);

}  // namespace drillwave
