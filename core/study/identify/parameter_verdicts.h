// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals and verdicts of the parameters of an answer (theory of identification §8).
#pragma once

#include <vector>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/law_checks.h"

namespace drillwave {

/// Fills parameters, covariance and common movements. `atLeast` are least half-widths of ln k, ln γ, gap,
/// ln F1 and ln s1.
void fillParameters(const LawTrials& trials, const std::vector<double>& atLeast, RecordAnswer& answer);

/// The interval of the gap reaches down to 0: a bent beginning of the law looks the same.
void openGap(RecordAnswer& answer);

}  // namespace drillwave
