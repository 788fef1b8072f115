// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the parameter values at which each line takes the goal.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Accuracy with which the output of a blow must equal the goal, so that the search for the position ends. It
/// is relative to the goal or to the variation of the output along the line, whichever is larger. If no
/// position is found within 100 times this accuracy, the output is taken to jump across the goal.
inline constexpr double goalAccuracy = 1e-11;

/// Maximum number of positions per curve that are confirmed by solving a blow there. A position is a
/// parameter value at which the output takes the goal value. Further positions are only read from the fitted
/// curve.
inline constexpr std::size_t mostSoughtPlaces = 64;

/// Computing work of a search for the parameter values that give the goal.
struct GoalWork {
    bool stopped = false;  ///< set if the stop token ended the search; the lines then have no goal result
    std::uint64_t solves = 0;
    /// Computing work of all blows of the search: number of polynomial wave pieces, or time steps × nodes for
    /// drill strings.
    long effort = 0;
};

/// Finds the parameter values at which the first output of the question equals the goal, for every line.
/// Stores them in CurveLine::goal and returns the work done. Does nothing if the question has no goal.
/// Each position is found on the fitted curve and then confirmed by solving a blow there. If the blow does
/// not confirm it, the position is narrowed down by solving more blows. This ends when the output equals the
/// goal or jumps across it.
/// If the curve is only known at points, positions between two points are not narrowed down. The result does
/// not depend on the number of threads `jobs` (≥ 1).
GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop);

}  // namespace drillwave
