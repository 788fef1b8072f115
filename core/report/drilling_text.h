// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows for people.
#pragma once

#include <string>

#include "core/report/drilling_report.h"

namespace drillwave {

/// What many blows come to: the verdict and what to do about it, the spreads of gap, penetration, impulse and
/// force, whether the motion repeats, energy and balances, alerts.
std::string drillingText(const DrillingReport& report, OutputUnits units,
                         const ReadingStyle& style = plainStyle());

}  // namespace drillwave
