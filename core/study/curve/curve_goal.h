// SPDX-License-Identifier: GPL-3.0-or-later
// Parameter values at which an output equals a wanted value (the goal).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/numeric/estimate.h"

namespace drillwave {

/// Parameter value at which an output equals the goal, or at which it jumps across the goal.
struct GoalPlace {
    enum class Kind {
        crossing,  ///< the output passes through the goal
        touch,     ///< the output reaches the goal and turns back
        /// The output equals the goal where the range, or the part of it with results, begins or ends.
        end,
        everywhere,  ///< the output equals the goal over the whole range, within errors
        /// Two neighbouring solved points lie on opposite sides of the goal; the output is not known between
        /// them.
        between,
        jump,  ///< the output jumps across the goal, so no parameter value gives it
    };
    Kind kind = Kind::crossing;
    /// Parameter value in SI units. For a jump, or between two points, the true position is anywhere within
    /// its error.
    Estimate x = {};
    /// Output solved at x, in the unit of its column; for a jump, or between two points, the value before the
    /// goal.
    Estimate value = {};
    /// Output after a jump, or at the second of two points; used only for the kinds `jump` and `between`.
    double valueAfter = 0;
    bool rising = false;  ///< whether the output increases with x where it passes the goal

    bool isGiven() const { return kind != Kind::jump; }
    /// Returns whether the output lies on opposite sides of the goal before and after this place.
    bool isPassed() const { return kind == Kind::crossing || kind == Kind::between || kind == Kind::jump; }
    bool operator==(const GoalPlace&) const = default;
};

std::string_view name(GoalPlace::Kind kind);

/// Result of the search for a goal along one curve: the parameter values at which the output takes the goal
/// value.
struct GoalAnswer {
    /// Places on the curve where the output equals the goal or crosses it, ascending in the parameter.
    std::vector<GoalPlace> places;
    /// Whether `places` contains every place in the range, within the errors of the curve. False if part of
    /// the range is solved only at points or has no result.
    bool isComplete = true;
    /// Value of the output that is closest to the goal value, and where it occurs. Given if no parameter
    /// value reaches the goal; empty if the curve has no result at all.
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
