// SPDX-License-Identifier: GPL-3.0-or-later
// Required feed force along a parameter.
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

/// Required feed force at one value of a parameter.
struct ThrustPoint {
    double value = 0;  ///< value of the parameter, in SI units
    FeedEstimate feed;
    Message reason;  ///< reason why there are no numbers; empty if there are

    const ThrustNeed& need(ThrustCase which) const { return feed.need(which); }
};

/// Required feed force at several values of a parameter, in the order of the values. After a stop request it
/// has only the points that were finished.
struct ThrustCurve {
    std::vector<ThrustPoint> points;
    bool stopped = false;
};

/// Callback for progress, called on the calling thread with all points so far.
using ThrustCurveProgress = std::function<void(const ThrustCurve&)>;

/// Returns the required feed force for several values of a parameter (SI, within its allowed range). A point
/// has a reason instead of numbers if the value does not apply to the scenario or makes it invalid. A point
/// also has a reason if thrustProblem() gives one or if its blow cannot be solved. `limits` is the maximum
/// work of each blow. The result does not depend on the number of threads `jobs` (≥ 1).
ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        int jobs, const std::stop_token& stop = {}, const ThrustCurveProgress& progress = {},
                        const WorkLimits& limits = {});

/// Returns the required feed force for several values of a parameter, computed on the calling thread.
/// Coefficients of restitution that `finder` has already computed are used again, and new ones are stored in
/// it.
ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        GapReboundFinder& finder, const std::stop_token& stop = {},
                        const ThrustCurveProgress& progress = {});

/// Returns the required feed force of a scenario as a point that can be drawn beside a curve of
/// thrustAlong(). `value` is the value of the curve's parameter in this scenario, NaN if it has none; it is
/// stored in the point.
ThrustPoint thrustPoint(const Scenario& scenario, double value, GapReboundFinder& finder,
                        const std::stop_token& stop = {});

}  // namespace drillwave
