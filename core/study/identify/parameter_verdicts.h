// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals and verdicts of the identified parameters (theory of identification §8).
#pragma once

#include <vector>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/law_checks.h"

namespace drillwave {

/// Sets the parameters of `answer`, their covariance, and their errors from sources common to all records.
/// `atLeast` are lower limits of the half-widths of stiffness, gamma, gap [m], corner force and corner slope
/// (logarithms except for the gap).
void fillParameters(const LawTrials& trials, const std::vector<double>& atLeast, RecordAnswer& answer);

/// Extends the 95 % interval of the gap down to 0. Used if a curved start of the rock law explains the record
/// as well as a gap.
void openGap(RecordAnswer& answer);

}  // namespace drillwave
