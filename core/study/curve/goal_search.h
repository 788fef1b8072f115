// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the places where the lines of a study take its goal.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// How near the goal a place is solved for, of the goal or of what the output rises along the line, whichever
/// is larger; where it cannot be brought nearer than a hundred times that, it jumps.
inline constexpr double goalAccuracy = 1e-11;

/// Maximum number of places of a line that are solved for; further ones are taken from the curve.
inline constexpr std::size_t mostSoughtPlaces = 64;

/// Work of a search.
struct GoalWork {
    bool stopped = false;  ///< by the stop token: the lines have no result
    std::uint64_t solves = 0;
    long effort = 0;  ///< of these solves
};

/// Gives every line its CurveLine::goal, that of the question's first column; nothing without a goal. Every
/// place is found by the curve and then solved for: a blow there confirms it, or the bracket is closed in,
/// until the output is at the goal or leaps over it. Between points of an output that has no smooth course
/// nothing is closed in. Does not depend on `jobs` (≥ 1).
GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop);

}  // namespace drillwave
