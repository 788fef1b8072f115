// SPDX-License-Identifier: GPL-3.0-or-later
// Between which places a curve takes a value, by its pieces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/fit_features.h"

namespace drillwave {

/// Where a curve comes from one side of a goal and goes on; in shares of the way.
struct GoalBracket {
    Estimate share;   ///< where it is at the goal, as far as its error tells
    double from = 0;  ///< the bracket: at its ends the curve is clearly on the sides named, if on any
    double to = 0;
    double valueFrom = 0;  ///< of the curve at `from`
    double valueTo = 0;
    int before = 0;       ///< −1 below, +1 above; 0 where the curve begins at the goal
    int after = 0;        ///< −1 below, +1 above; 0 where the curve ends at the goal
    double margin = 0;    ///< error of the curve there: closer values cannot be distinguished from the goal
    bool isOpen = false;  ///< inside, between two points of a curve that is only known at points

    bool isPassed() const { return before * after < 0; }
};

/// All of them, ascending. A curve that stays within its error of the goal is in one bracket. Where there is
/// a stretch without an answer the curve ends and begins again.
std::vector<GoalBracket> goalBrackets(std::span<const MonotoneSegment> segments, double goal);

/// The value of the curve that comes nearest to the goal, and its share of the way. Requires a segment.
struct NearestValue {
    Estimate share;
    Estimate value;
};
NearestValue nearestTo(std::span<const MonotoneSegment> segments, double goal);

}  // namespace drillwave
