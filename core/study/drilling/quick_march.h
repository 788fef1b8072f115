// SPDX-License-Identifier: GPL-3.0-or-later
// A sequence of blows that is there within a second.
#pragma once

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Work of a core in a second, on a typical computer [cells times nodes].
inline constexpr double workOfSecond = 2e7;

/// Returns the usual length of a sequence in the window: the blows of the scenario; by default 300, of which
/// 100 are transient.
DrillingSettings windowSettingsOf(const Scenario& scenario);

/// Returns a request for penetration and gap of a sequence, with errors, and nothing else.
DrillingRequest quickWants();

/// Way of following a sequence that was not requested.
struct QuickMarch {
    DrillingSettings settings;
    double seconds = 0;        ///< that it takes, on a typical computer
    bool isWithinTime = true;  ///< otherwise it has the fewest blows and is followed on request
};

/// windowSettingsOf() with no more blows than fit into `seconds` [s], and no fewer than 100. Requires that
/// there are no drillingRefusals().
QuickMarch quickMarchOf(const Scenario& scenario, double seconds = 1);

}  // namespace drillwave
