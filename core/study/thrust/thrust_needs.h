// SPDX-License-Identifier: GPL-3.0-or-later
// What feed force blows need, from the one at hand to the worst.
#pragma once

#include <array>
#include <optional>

#include "core/blow/feed_decision.h"
#include "core/blow/feed_verdict.h"
#include "core/model/scenario.h"
#include "core/study/thrust/gap_rebounds.h"

namespace drillwave {

/// What one case needs, by its own e. The need is a bracket: from the thrust f I0 (1+e) of full penetration
/// to the f I0 (1+2e) that brings a bit that was at rest back before the next blow even if nothing damps.
/// Margin and frequency limit are about its lower end.
struct ThrustNeed {
    /// Whether it can be told: of a drill string not what counts its gaps, which have no period.
    bool known = true;
    Estimate cor;
    double thrust = 0;             ///< f I0 (1+e) [N]
    double thrustUndamped = 0;     ///< f I0 (1+2e) [N]
    std::optional<double> margin;  ///< effective force over `thrust`, less 1, with an installed thrust
    /// Up to which blow frequency the effective force is at least `thrust` [Hz].
    std::optional<double> frequencyLimit;
    Feed feed = Feed::unknown;           ///< the effective force, judged by this e
    std::optional<GapAtBlow> gapAtBlow;  ///< at the effective force, by this e
};

/// In the order of ThrustCase.
using ThrustNeeds = std::array<ThrustNeed, thrustCaseCount>;

/// By the e of the blow itself and those that its rock and gap may bring, which must be known. Requires
/// thrustProblem() to be empty.
ThrustNeeds thrustNeeds(const Scenario& scenario, const Estimate& cor, const GapRebounds& rebounds);

/// By the e of the blow itself of a drill string, whose hammer hands on so much of its momentum, and on rigid
/// rock; the others are not known. Requires thrustProblem() to be empty.
ThrustNeeds stringThrustNeeds(const Scenario& scenario, const Estimate& cor, double transferred);

/// The one with the largest `thrust` of those that are known.
const ThrustNeed& largestOf(const ThrustNeeds& needs);
/// The same for a decision.
WidestNeed widestOf(const ThrustNeeds& needs);

}  // namespace drillwave
