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

/// What makes a question unusable, as problemsOf(CurveQuestion); whole numbers can be asked for here.
std::vector<Message> sampledProblemsOf(const CurveQuestion& question);

/// Told on the calling thread how many points are solved, of all, and, whenever the points lie twice as close
/// as before, the lines through those that are there.
struct SampledProgress {
    std::function<void(std::size_t done, std::size_t of)> tell;
    std::function<void(CurveStudy soFar)> show;
};

/// Solves the CurveQuestion::along.count (≥ 2) values of every line, coarse ones first: the rows of the sweep
/// of family and parameter, bit for bit, whatever `jobs` (≥ 1) is. Outputs are straight between the points;
/// their features are the least and the largest value. Requires sampledProblemsOf() to be empty.
CurveStudy sampleCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                       const SampledProgress& progress = {});

}  // namespace drillwave
