// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets of the parameter within which a curve takes the goal value.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/fit_features.h"

namespace drillwave {

/// Stretch of a curve within which it passes or touches the goal value. Positions are shares of the parameter
/// range, 0 … 1.
struct GoalBracket {
    Estimate share;  ///< position at which the curve takes the goal, with its error
    /// Start of the bracket. Here the curve clearly lies on the side `before` of the goal, and at the end
    /// `to` on the side `after`.
    double from = 0;
    double to = 0;
    /// Value of the curve at the start of the bracket (`from`), in the unit of the output.
    double valueFrom = 0;
    /// Value of the curve at the end of the bracket (`to`), in the unit of the output.
    double valueTo = 0;
    /// Side of the goal on which the curve lies before the bracket: −1 below, +1 above, 0 if the curve begins
    /// at the goal.
    int before = 0;
    /// Side of the goal on which the curve lies after the bracket: −1 below, +1 above, 0 if the curve ends at
    /// the goal.
    int after = 0;
    /// Error of the curve within the bracket, in the unit of the output. Values closer to the goal than this
    /// cannot be distinguished from it.
    double margin = 0;
    /// Whether the bracket lies between two solved points, with the curve not known between them.
    bool isOpen = false;

    bool isPassed() const { return before * after < 0; }
};

/// Returns brackets of all places where the curve takes the goal value, ascending. A stretch over which the
/// curve stays within its error of the goal forms one bracket. Where there is no result, the curve ends, and
/// it begins again after that.
std::vector<GoalBracket> goalBrackets(std::span<const MonotoneSegment> segments, double goal);

/// Value of the curve that is closest to the goal, and the share of the range where it occurs.
struct NearestValue {
    Estimate share;
    Estimate value;
};
/// Returns the value of the curve that is closest to the goal. Requires at least one segment.
NearestValue nearestTo(std::span<const MonotoneSegment> segments, double goal);

}  // namespace drillwave
