// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the installed thrust is enough, and for what: what is told before anything else. Its words are in
// report/feed_words.h.
#pragma once

#include <optional>

#include "core/blow/feed_verdict.h"
#include "core/blow/thrust_case.h"
#include "core/model/scenario.h"

namespace drillwave {

/// The largest of the needs beyond the one of the blow at hand.
struct WidestNeed {
    ThrustCase which = ThrustCase::rigidRock;
    double thrust = 0;       ///< for full penetration, f I0 (1+e) by its own e [N]
    bool ofAllGaps = false;  ///< all four needs are known; of a drill string only this blow and rigid rock
    bool operator==(const WidestNeed&) const = default;
};

struct FeedDecision {
    enum class Kind {
        noUnits,         ///< the scenario is given by its dimensionless groups
        noFrequency,     ///< and so there is no thrust to compare with
        noThrust,        ///< nothing is installed; the needs are known
        enough,          ///< for the widest need too
        enoughThisBlow,  ///< for this blow; not for the widest need, or that is not known
        notEnough,       ///< not for this blow either
    };
    Kind kind = Kind::noUnits;
    std::optional<FeedForce> force = {};    ///< installed
    double weight = 0;                      ///< along the hole, 0 where no inclination is given [N]
    double frequency = 0;                   ///< of blows [Hz]
    double need = 0;                        ///< for full penetration by this blow, f I0 (1+e) [N]
    std::optional<WidestNeed> widest = {};  ///< where it is known
    bool operator==(const FeedDecision&) const = default;

    /// Whether the widest need is known and larger than that of this blow.
    bool hasWiderNeed() const { return widest && widest->thrust > need; }
    /// The thrust to install for such a need: what the weight along the hole does not bring [N], ≥ 0.
    double thrustFor(double needed) const;
    /// Up to which blow frequency what is installed is enough for such a need [Hz]; 0 where nothing presses
    /// to the rock.
    double frequencyFor(double needed) const;
};

/// By the verdict on the blow at hand, nothing where judgeFeed() has none. Without a widest need a drill
/// string is held against rigid rock, e = 1, as well.
FeedDecision decideFeed(const Scenario& scenario, const std::optional<FeedVerdict>& verdict,
                        std::optional<WidestNeed> widest = {});

}  // namespace drillwave
