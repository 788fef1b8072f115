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

/// Returns the reasons why a curve cannot be computed at points; empty if it can. The checks are those of a
/// sweep, of the family and of the goal. Unlike in problemsOf(CurveQuestion), whole-number parameters, narrow
/// ranges and any output are allowed.
std::vector<Message> sampledProblemsOf(const CurveQuestion& question);

/// Callbacks for progress, called on the calling thread. `tell` receives the number of solved points and of
/// all points. `show` receives the lines through the points solved so far, each time the spacing is halved.
struct SampledProgress {
    std::function<void(std::size_t done, std::size_t of)> tell;
    std::function<void(CurveStudy soFar)> show;
};

/// Returns curves solved only at CurveQuestion::along.count (≥ 2) parameter values, from coarse to fine
/// spacing, for each value of the second parameter (family). The values are bit for bit those of a sweep over
/// both parameters, for any number of threads `jobs` (≥ 1). Outputs are linear between the points; the only
/// features are the minimum and the maximum. Requires sampledProblemsOf() to be empty.
CurveStudy sampleCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                       const SampledProgress& progress = {});

}  // namespace drillwave
