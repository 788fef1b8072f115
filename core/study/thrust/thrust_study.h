// SPDX-License-Identifier: GPL-3.0-or-later
// The feed that one scenario needs, and how the installed one compares.
#pragma once

#include <optional>
#include <stop_token>

#include "core/blow/feed_estimate.h"
#include "core/blow/method.h"
#include "core/study/thrust/gap_rebounds.h"
#include "core/text/message.h"

namespace drillwave {

struct ThrustStudy {
    FeedEstimate feed;
    std::optional<GapRebounds> rebounds;  ///< for the cases of all gaps, whose period a string has not
    double transferred = 1;           ///< impulse transferred by the hammer [I0] (ImpactSummary::transferred)
    std::optional<double> shareFull;  ///< share of all gaps at which the effective force is ≥ f I0 (1+e)
    Message reason;                   ///< why there is no result; empty if there is one
    Hindrance hindrance = Hindrance::other;  ///< if the scenario's own blow is the reason
    bool stopped = false;                    ///< by the stop token: no result

    const ThrustNeed& need(ThrustCase which) const { return feed.need(which); }
    const ThrustNeed& largestNeed() const { return feed.largest(); }
    /// Effective force over the largest of the four `thrust`, less 1: the output `thrust_margin`. Nothing of
    /// a drill string, of which not all four are known.
    std::optional<double> margin() const;
};

/// Why a scenario has no study of its thrust: it is not valid, or has a thrustProblem(). Empty where it has.
Message thrustRefusal(const Scenario& scenario);

/// Returns no result if there is a thrustRefusal(), if one of its two curves over the gap takes more wave
/// pieces than `mostPieces`, or if the scenario's own blow takes more than `limits`.
ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop = {}, const GapProgress& progress = {},
                        long mostPieces = anyNumberOfPieces, const WorkLimits& limits = {});

/// Studies a drill string by one run of its solver: one blow, and no gaps. Nothing for a uniform rod, whose
/// gaps are to be studied.
std::optional<ThrustStudy> studyStringThrust(const Scenario& scenario, NetworkAccuracy accuracy,
                                             MethodSolver& solver, const std::stop_token& stop);

}  // namespace drillwave
