// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of a parameter give an output the value that is wanted.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/numeric/estimate.h"

namespace drillwave {

/// A value of the parameter that gives the goal, or at which the output leaps over it.
struct GoalPlace {
    enum class Kind {
        crossing,    ///< the output passes the goal
        touch,       ///< reaches the goal and turns round
        end,         ///< at the goal where the range, or the known part of it, begins or ends
        everywhere,  ///< the same as the goal everywhere, within errors
        between,     ///< on one side at one point and on the other at the next: only known at points
        jump,        ///< it leaps over the goal: no value gives it
    };
    Kind kind = Kind::crossing;
    Estimate x = {};        ///< SI; of a jump or between points, where within its error is not known
    Estimate value = {};    ///< the output solved there; of a jump or between points, before it
    double valueAfter = 0;  ///< of a jump, or between points
    bool rising = false;    ///< where it passes the goal: with growing x

    bool isGiven() const { return kind != Kind::jump; }
    /// Returns whether the output passes from one side to the other.
    bool isPassed() const { return kind == Kind::crossing || kind == Kind::between || kind == Kind::jump; }
    bool operator==(const GoalPlace&) const = default;
};

std::string_view name(GoalPlace::Kind kind);

/// Places of a goal along a line.
struct GoalAnswer {
    std::vector<GoalPlace> places;  ///< ascending
    /// Whether these are all places in the range, within the errors of the curve; false where a part of it is
    /// only known at points, or has no result.
    bool isComplete = true;
    /// If no place reaches the goal: the nearest value. Nothing if there is no result at all.
    struct Nearest {
        Estimate x = {};  ///< SI
        Estimate value = {};
        bool operator==(const Nearest&) const = default;
    };
    std::optional<Nearest> nearest = {};

    bool isReached() const;
    bool operator==(const GoalAnswer&) const = default;
};

}  // namespace drillwave
