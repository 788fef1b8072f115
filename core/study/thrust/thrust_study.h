// SPDX-License-Identifier: GPL-3.0-or-later
// Required feed force of one scenario, compared with the installed feed force.
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
    /// Coefficients of restitution e for ThrustCase::gapQuantile and ThrustCase::elasticWorst, the two cases
    /// that consider all gaps. Empty for a drill string, whose e does not repeat periodically when the gap
    /// grows.
    std::optional<GapRebounds> rebounds;
    /// Momentum that the hammer or hammer force transfers to the rod or drill string, divided by I0, or by p0
    /// for a hammer (see ImpactSummary::transferred).
    double transferred = 1;
    /// Share of all gaps, 0 … 1, at which the effective feed force is sufficient: at least f I0 (1 + e) with
    /// the e of the gap. Empty without an installed feed force, and for a drill string.
    std::optional<double> shareFull;
    Message reason;                          ///< reason why there is no result; empty if there is one
    Hindrance hindrance = Hindrance::other;  ///< kind of obstacle, if the scenario's own blow is the reason
    bool stopped = false;  ///< set if the stop token ended the study; there is then no result

    const ThrustNeed& need(ThrustCase which) const { return feed.need(which); }
    const ThrustNeed& largestNeed() const { return feed.largest(); }
    /// Returns the output `thrust_margin`: the effective feed force divided by the largest of the required
    /// feed forces of all four ThrustCase, minus 1. Empty for a drill string, for which not all four are
    /// known.
    std::optional<double> margin() const;
};

/// Returns why the required feed force of a scenario cannot be studied: the scenario is invalid or
/// thrustProblem() gives a reason. Empty if it can.
Message thrustRefusal(const Scenario& scenario);

/// Returns the required feed forces of a scenario. There is no result if thrustRefusal() gives a reason or if
/// the scenario's own blow exceeds `limits`. The same holds if one of the two curves over the gap takes more
/// than `mostPieces` wave pieces (the solver's unit of work).
ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop = {}, const GapProgress& progress = {},
                        long mostPieces = anyNumberOfPieces, const WorkLimits& limits = {});

/// Returns the required feed force of a drill string, computed from one solved blow. Empty for a uniform rod,
/// for which studyThrust() also studies all gaps.
std::optional<ThrustStudy> studyStringThrust(const Scenario& scenario, NetworkAccuracy accuracy,
                                             MethodSolver& solver, const std::stop_token& stop);

}  // namespace drillwave
