// SPDX-License-Identifier: GPL-3.0-or-later
// Parameter values at which an output equals a wanted value (the goal).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/numeric/estimate.h"

namespace drillwave {

/// Parameter value at which an output equals the goal (the wanted value), or at which it jumps across the
/// goal.
struct GoalPlace {
    enum class Kind {
        crossing,  ///< the output passes through the goal
        touch,     ///< the output reaches the goal and turns back
        /// The output equals the goal at the start or end of the range, or of the part of the range that has
        /// results.
        end,
        everywhere,  ///< the output equals the goal over the whole range, within errors
        /// Two neighbouring solved points lie on opposite sides of the goal; the output is not known between
        /// them.
        between,
        jump,  ///< the output jumps across the goal, so no parameter value gives it
    };
    Kind kind = Kind::crossing;
    /// Parameter value in SI units, with its error. For a jump, or between two points, the true position may
    /// be anywhere within this error.
    Estimate x = {};
    /// Output at x, in the unit of its column. For a jump, or between two points, it is the value on the side
    /// of smaller parameter values.
    Estimate value = {};
    /// Output on the other side, at larger parameter values: after a jump, or at the second of two points.
    /// Used only for the kinds `jump` and `between`.
    double valueAfter = 0;
    bool rising = false;  ///< whether the output increases with x where it passes the goal

    bool isGiven() const { return kind != Kind::jump; }
    /// Returns whether the output passes the goal here: it lies below the goal on one side and above it on
    /// the other.
    bool isPassed() const { return kind == Kind::crossing || kind == Kind::between || kind == Kind::jump; }
    bool operator==(const GoalPlace&) const = default;
};

std::string_view name(GoalPlace::Kind kind);

/// Result of the search for a goal along one curve: the parameter values at which the output takes the goal
/// value.
struct GoalAnswer {
    /// Parameter values at which the output equals the goal or crosses it, ascending.
    std::vector<GoalPlace> places;
    /// Whether `places` contains all parameter values in the range that give the goal. False if part of the
    /// range is solved only at points or has no result, so that some may be missing.
    bool isComplete = true;
    /// Value of the output that is closest to the goal, and the parameter value where it occurs. Given only
    /// if no parameter value reaches the goal; empty otherwise, or if the curve has no result at all.
    struct Nearest {
        Estimate x = {};  ///< parameter value in SI units
        Estimate value = {};
        bool operator==(const Nearest&) const = default;
    };
    std::optional<Nearest> nearest = {};

    bool isReached() const;
    bool operator==(const GoalAnswer&) const = default;
};

}  // namespace drillwave
