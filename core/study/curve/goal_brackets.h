// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets of the parameter within which a curve takes the goal value.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/fit_features.h"

namespace drillwave {

/// Stretch of a curve within which it passes or touches the goal (the wanted value of the output). Positions
/// are shares 0 … 1 of the parameter range.
struct GoalBracket {
    Estimate share;  ///< position at which the curve takes the goal, with its error
    /// Start of the bracket. At this position the curve clearly lies on the side `before` of the goal. At the
    /// end of the bracket, `to`, it lies on the side `after`.
    double from = 0;
    double to = 0;
    /// Value of the curve at the start of the bracket (`from`), in the unit of the output.
    double valueFrom = 0;
    /// Value of the curve at the end of the bracket (`to`), in the unit of the output.
    double valueTo = 0;
    /// Side of the goal on which the curve lies before the bracket: −1 if the values are below the goal, +1
    /// if above. It is 0 if the curve begins with the goal value.
    int before = 0;
    /// Side of the goal on which the curve lies after the bracket: −1 if the values are below the goal, +1 if
    /// above. It is 0 if the curve ends with the goal value.
    int after = 0;
    /// Largest error of the curve within the bracket, in the unit of the output. The search cannot tell
    /// whether values that are closer to the goal than this error equal the goal.
    double margin = 0;
    /// Whether the bracket lies between two solved points and the course of the curve between them is not
    /// known.
    bool isOpen = false;

    bool isPassed() const { return before * after < 0; }
};

/// Returns brackets of all positions at which the curve takes the goal value, ascending. If the curve stays
/// within its error of the goal over a stretch, that stretch is one bracket. Parts of the curve that are
/// separated by a stretch without results are searched separately.
std::vector<GoalBracket> goalBrackets(std::span<const MonotoneSegment> segments, double goal);

/// Value of the curve that is closest to the goal (the wanted value of the output), and where it occurs. The
/// position is a share 0 … 1 of the parameter range.
struct NearestValue {
    Estimate share;
    Estimate value;
};
/// Returns the value of the curve that is closest to the goal. Requires at least one segment.
NearestValue nearestTo(std::span<const MonotoneSegment> segments, double goal);

}  // namespace drillwave
