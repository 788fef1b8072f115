// SPDX-License-Identifier: GPL-3.0-or-later
// The needs of the thrust along a parameter.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/blow/method.h"
#include "core/model/parameter.h"
#include "core/study/thrust/gap_rebounds.h"
#include "core/text/message.h"

namespace drillwave {

/// Value of the parameter, with its result.
struct ThrustPoint {
    double value = 0;  ///< of the parameter, SI
    FeedEstimate feed;
    Message reason;  ///< why there are no numbers; empty when there are

    const ThrustNeed& need(ThrustCase which) const { return feed.need(which); }
};

/// Points in the order of the values; after a stop, those that were finished.
struct ThrustCurve {
    std::vector<ThrustPoint> points;
    bool stopped = false;
};

/// Called on the calling thread with all points so far.
using ThrustCurveProgress = std::function<void(const ThrustCurve&)>;

/// Sets the parameter to one value (SI, inside its hard range) after the other. It does not depend on `jobs`
/// (≥ 1). A value that has no meaning there, with which the scenario is not valid, has no thrust
/// (thrustProblem()) or cannot be solved has a reason and no numbers. The blow of a point may take
/// `limits`.
ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        int jobs, const std::stop_token& stop = {}, const ThrustCurveProgress& progress = {},
                        const WorkLimits& limits = {});

/// Does the same on the calling thread, with the memory of the finder of earlier curves.
ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        GapReboundFinder& finder, const std::stop_token& stop = {},
                        const ThrustCurveProgress& progress = {});

/// Returns the point of the unchanged scenario, `value` being that of the parameter in it (NaN if none).
ThrustPoint thrustPoint(const Scenario& scenario, double value, GapReboundFinder& finder,
                        const std::stop_token& stop = {});

}  // namespace drillwave
