// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of many blows from their march.
#pragma once

#include "core/blow/drill_problems.h"
#include "core/study/drilling/drilling_study.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the available outputs. Penetration error needs `cellError`, λ `lyapunov` of DrillingRequest.
DrillNumbers drillNumbersOf(const DrillingResult& result);

/// Returns why there are no statistics: pushed back, stopped, or not solved; empty if there are.
Message whyNoStatistics(const DrillingResult& result);

}  // namespace drillwave
