// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs along one parameter by points alone: of drill strings, whose waves leave more kinks than can be
// followed.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Returns the problems of a question, as problemsOf(CurveQuestion); whole numbers are allowed here.
std::vector<Message> sampledProblemsOf(const CurveQuestion& question);

/// Called on the calling thread with the number of solved points and of all points; and, whenever the
/// distance of the points is halved, with the lines through the points so far.
struct SampledProgress {
    std::function<void(std::size_t done, std::size_t of)> tell;
    std::function<void(CurveStudy soFar)> show;
};

/// Solves the CurveQuestion::along.count (≥ 2) values of every line, coarse ones first: the rows of the sweep
/// of family and parameter, bit for bit, for any `jobs` (≥ 1). Outputs are straight between the points; their
/// features are the least and the largest value. Requires sampledProblemsOf() to be empty.
CurveStudy sampleCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                       const SampledProgress& progress = {});

}  // namespace drillwave
