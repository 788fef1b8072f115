// SPDX-License-Identifier: GPL-3.0-or-later
// What the feed force does between the blows: one judgement. Its words are in report/feed_words.h.
#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "core/blow/feed_force.h"
#include "core/blow/undamped_motion.h"
#include "core/model/scenario.h"

namespace drillwave {

/// The effective force F against blow frequency f, impulse I0 and COR e (theory §10).
enum class Feed {
    unknown,          ///< no thrust is given
    pushedBack,       ///< F < f I0: less than the hammer pushes back
    penetrationLost,  ///< f I0 ≤ F < f I0 (1+e): each blow penetrates less than it could
    fullRate,  ///< f I0 (1+e) ≤ F < f I0 (1+2e): full penetration, the bit leaves the rock between blows
    /// F ≥ f I0 (1+2e): undamped, a bit that was at rest is back before the next blow, and one that bounces
    /// goes on bouncing
    backInTime,
    resting,  ///< F ≥ f I0 (1+e)/(1−e): undamped, the bit rests on the rock before every blow
};

/// "unknown", "pushed_back", "penetration_lost", "full_rate", "back_in_time"; the last of `resting` too.
std::string_view name(Feed feed);

/// The thresholds of the feed for blows of one e, all in N.
struct FeedThresholds {
    double balance = 0;   ///< f I0
    double fullRate = 0;  ///< f I0 (1+e), the thrust needed for full penetration
    double returned = 0;  ///< f I0 (1+2e), at which a bit that was at rest is back even if nothing damps
    /// f I0 (1+e)/(1−e), at which the bit comes to rest even if nothing damps; infinite for e ≥ 1
    double resting = std::numeric_limits<double>::infinity();
    bool operator==(const FeedThresholds&) const = default;
};

/// The feed force between its thresholds, all in N.
struct FeedVerdict : FeedThresholds {
    std::optional<FeedForce> force;  ///< nothing where no thrust is installed
    Feed feed = Feed::unknown;
    bool operator==(const FeedVerdict&) const = default;

    /// F [N], nothing where no thrust is installed.
    std::optional<double> effective() const;
    /// F/(f I0 (1+e)) − 1, likewise.
    std::optional<double> margin() const;
    /// Whether penetration is lost, or worse: what is warned of.
    bool isTooLittle() const { return feed == Feed::pushedBack || feed == Feed::penetrationLost; }
};

/// The verdict by its thresholds.
FeedVerdict feedVerdict(const std::optional<FeedForce>& force, const FeedThresholds& thresholds);

/// Judges the feed for blows with that COR and, of a drill string, that share of the hammer's momentum
/// handed on: thrustNeeded(). nullopt where thrustProblem() says why.
std::optional<FeedVerdict> judgeFeed(const Scenario& scenario, double cor, double transferred = 1);

/// Where the bit is when the hammer strikes, if nothing damps the rebound.
struct GapAtBlow {
    UndampedMotion motion;
    double feed = 0;        ///< φ = F/(f I0)
    double roundTrips = 0;  ///< n_b = 1/(2 T f)
    double gap = 0;         ///< y v0/f [m] (T37), 0 but where it bounces
    double inD0 = 0;        ///< the same, y n_b of a uniform rod [d0]
};

/// Likewise. A drill string moves as a rigid body. nullopt where there is no verdict, or no thrust is
/// installed.
std::optional<GapAtBlow> gapAtBlow(const Scenario& scenario, double cor, double transferred = 1);

}  // namespace drillwave
