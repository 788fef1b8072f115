// SPDX-License-Identifier: GPL-3.0-or-later
// Between which places a curve takes a value, by its pieces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/fit_features.h"

namespace drillwave {

/// Part of a curve that passes a goal, or touches it; in shares of the range.
struct GoalBracket {
    Estimate share;   ///< at the goal, within its error
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

/// Returns all brackets, ascending. A curve that stays within its error of the goal is in one bracket. At a
/// stretch without a result the curve ends and begins again.
std::vector<GoalBracket> goalBrackets(std::span<const MonotoneSegment> segments, double goal);

/// Value of the curve nearest to the goal, and its share of the range. Requires a segment.
struct NearestValue {
    Estimate share;
    Estimate value;
};
NearestValue nearestTo(std::span<const MonotoneSegment> segments, double goal);

}  // namespace drillwave
