// SPDX-License-Identifier: GPL-3.0-or-later
// What feed force blows need, from the one at hand to the worst, and how the installed one compares.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/blow/feed_verdict.h"
#include "core/blow/thrust.h"
#include "core/model/scenario.h"
#include "core/study/gap/gap_statistics.h"

namespace drillwave {

/// What the thrust is wanted for, from the case at hand to the worst.
enum class ThrustCase {
    scenario,      ///< the blow as given
    gapQuantile,   ///< 95 % of all gaps of a period, in this rock
    rigidRock,     ///< e = 1, the usual estimate
    elasticWorst,  ///< γ = 1 at this stiffness, the worst of all gaps
};
inline constexpr std::size_t thrustCaseCount = 4;

/// "scenario", "gap_95_percent", "rigid_rock", "elastic_worst_gap".
std::string_view name(ThrustCase which);

/// What one case needs, by its own e. The need is a bracket: from the thrust f I0 (1+e) of full penetration
/// to the f I0 (1+2e) that brings the bit back before the next blow even if nothing damps. Margin and
/// frequency limit are about its lower end.
struct ThrustNeed {
    Estimate cor;
    double thrust = 0;             ///< f I0 (1+e) [N]
    double thrustUndamped = 0;     ///< f I0 (1+2e) [N]
    std::optional<double> margin;  ///< installed/thrust − 1, with an installed thrust
    /// Up to which blow frequency the installed thrust is at least `thrust` [Hz].
    std::optional<double> frequencyLimit;
    Feed feed = Feed::unknown;  ///< the installed thrust, judged by this e
};

struct ThrustStudy {
    std::array<ThrustNeed, thrustCaseCount> needs;  ///< in the order of ThrustCase
    std::optional<double> shareFull;  ///< share of all gaps at which the installed thrust is ≥ f I0 (1+e)
    FeedVerdict verdict;              ///< by the e of the scenario's own blow
    std::string reason;               ///< why there is no result; empty when there is
    bool stopped = false;             ///< on the stop token: no result

    const ThrustNeed& need(ThrustCase which) const { return needs[static_cast<std::size_t>(which)]; }
    const ThrustNeed& largestNeed() const;
    /// Installed thrust over the largest of the four `thrust`, less 1: `thrust_margin` of commands §4.4.
    std::optional<double> margin() const { return largestNeed().margin; }
};

/// Requires thrustProblem() to be empty.
ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop = {},
                        const GapProgress& progress = {});

}  // namespace drillwave
