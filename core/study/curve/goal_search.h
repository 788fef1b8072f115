// SPDX-License-Identifier: GPL-3.0-or-later
// Solves for the places where the lines of a study take its goal.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Accuracy of places that are solved for, relative to the goal or the rise of the output along the line, the
/// larger one; if the output stays a hundred times as far away, it jumps.
inline constexpr double goalAccuracy = 1e-11;

/// Maximum number of places of a line that are solved for; further ones are taken from the curve.
inline constexpr std::size_t mostSoughtPlaces = 64;

/// Work of a search.
struct GoalWork {
    bool stopped = false;  ///< by the stop token: the lines have no result
    std::uint64_t solves = 0;
    long effort = 0;  ///< of these solves
};

/// Sets CurveLine::goal of every line, for the first column of the question; nothing without a goal. Every
/// place is found from the curve and then solved for: a blow there confirms it, or the bracket is closed in,
/// until the output is at the goal or jumps over it. Between points of an output without a smooth course
/// nothing is closed in. Does not depend on `jobs` (≥ 1).
GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop);

}  // namespace drillwave
