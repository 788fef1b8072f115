// SPDX-License-Identifier: GPL-3.0-or-later
// What the feed force does between the blows: one judgement. Its words are in report/feed_words.h.
#pragma once

#include <optional>
#include <string_view>

#include "core/model/scenario.h"

namespace drillwave {

/// The installed thrust F against blow frequency f, impulse I0 and COR e (theory §10).
enum class Feed {
    unknown,          ///< no thrust is given
    pushedBack,       ///< F < f I0: less than the hammer pushes back
    penetrationLost,  ///< f I0 ≤ F < f I0 (1+e): each blow penetrates less than it could
    fullRate,    ///< f I0 (1+e) ≤ F < f I0 (1+2e): full penetration, the bit leaves the rock between blows
    backInTime,  ///< F ≥ f I0 (1+2e): the bit is back on the rock before the next blow, undamped
};

/// "unknown", "pushed_back", "penetration_lost", "full_rate", "back_in_time".
std::string_view name(Feed feed);

/// The installed thrust between its thresholds, all in N.
struct FeedVerdict {
    Feed feed = Feed::unknown;
    std::optional<double> installed;  ///< F: the effective force is taken to be the installed thrust alone
    double balance = 0;               ///< f I0
    double fullRate = 0;              ///< f I0 (1+e), the thrust needed for full penetration
    double returned = 0;              ///< f I0 (1+2e), at which the bit is back even if nothing damps
    bool operator==(const FeedVerdict&) const = default;
};

/// The verdict by its thresholds, all in N.
FeedVerdict feedVerdict(std::optional<double> installed, double balance, double fullRate, double returned);

/// Judges the installed thrust for blows with that COR, e ≥ 0. nullopt where thrustProblem() says why.
std::optional<FeedVerdict> judgeFeed(const Scenario& scenario, double cor);

}  // namespace drillwave
