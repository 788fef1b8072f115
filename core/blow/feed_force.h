// SPDX-License-Identifier: GPL-3.0-or-later
// The force that presses machine and rod to the rock.
#pragma once

#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

/// The effective force F of theory §10 and its parts. Friction of the feed is not counted.
struct FeedForce {
    double thrust = 0;  ///< installed [N]
    /// (machine mass + rod mass) g sin(inclination) [N], positive where it pulls to the rock; nothing where
    /// no inclination is given.
    std::optional<double> weight;
    bool operator==(const FeedForce&) const = default;

    double effective() const { return thrust + weight.value_or(0); }  ///< F [N]
    /// How much more it is than a thrust that is needed [N], over that.
    double marginOver(double needed) const { return effective() / needed - 1; }
};

/// nullopt where no thrust is installed.
std::optional<FeedForce> feedForceOf(const Scenario& scenario);

/// (machine mass + rod mass) g sin(inclination) [N]; nullopt without units or an inclination. Without a
/// machine mass it is the weight of the rod alone.
std::optional<double> weightAlongHole(const Scenario& scenario);

}  // namespace drillwave
