// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of many blows from their march.
#pragma once

#include "core/blow/drill_problems.h"
#include "core/study/drilling/drilling_study.h"
#include "core/text/message.h"

namespace drillwave {

/// Those that there are. The error of the penetration needs `cellError`, λ `lyapunov` of DrillingWants.
DrillNumbers drillNumbersOf(const DrillingResult& result);

/// Why there are no statistics: pushed back, stopped, or not solved; empty where there are.
Message whyNoStatistics(const DrillingResult& result);

}  // namespace drillwave
