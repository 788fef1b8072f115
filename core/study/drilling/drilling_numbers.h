// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a sequence of blows.
#pragma once

#include "core/blow/drill_problems.h"
#include "core/study/drilling/drilling_study.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the outputs that the result of a sequence of blows contains; the others are empty. The error of
/// the penetration requires DrillingRequest::cellError, the Lyapunov exponent λ requires
/// DrillingRequest::lyapunov.
DrillNumbers drillNumbersOf(const DrillingResult& result);

/// Returns why a sequence of blows has no statistics (pushed back, stopped, or not solved); empty if it has.
Message whyNoStatistics(const DrillingResult& result);

}  // namespace drillwave
