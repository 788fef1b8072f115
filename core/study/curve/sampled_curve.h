// SPDX-License-Identifier: GPL-3.0-or-later
// Curves solved only at points, without a fit. Used for drill strings, whose waves cause too many kinks to
// follow.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Returns the reasons why a curve cannot be computed at single points; empty if it can. The checks are those
/// of a sweep, of the second parameter (family) and of the goal. In contrast to problemsOf(CurveQuestion),
/// whole-number parameters, narrow ranges and any output are allowed.
std::vector<Message> sampledProblemsOf(const CurveQuestion& question);

/// Callbacks for progress, called on the calling thread. `tell` receives the number of solved points and of
/// all points. `show` receives curves through the points solved so far, each time the distance between solved
/// points is halved.
struct SampledProgress {
    std::function<void(std::size_t done, std::size_t of)> tell;
    std::function<void(CurveStudy soFar)> show;
};

/// Returns curves of straight lines between parameter values at which blows are solved. There are
/// CurveQuestion::along.count (≥ 2) such values for each value of the second parameter (family). The only
/// features are the minimum and the maximum.
/// The solved values are bit for bit those of a sweep over both parameters, for any number of threads `jobs`
/// (≥ 1). Widely spaced values are solved first, then those between them. If sampledProblemsOf() is not
/// empty, returns a study without lines, with the problems as CurveStudy::refusal.
CurveStudy sampleCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                       const SampledProgress& progress = {});

}  // namespace drillwave
