// SPDX-License-Identifier: GPL-3.0-or-later
// Sequence of blows short enough to be computed within about a second.
#pragma once

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Work that one processor core of a typical computer does in a second [cells × nodes].
inline constexpr double workOfSecond = 2e7;

/// Returns the settings of a sequence in the window: the number of blows of the scenario; by default 300, of
/// which 100 are transient.
DrillingSettings windowSettingsOf(const Scenario& scenario);

/// Returns a request for penetration and gap of a sequence with their errors, without the Lyapunov exponent.
DrillingRequest quickWants();

/// Settings of a sequence of blows that the window computes without being asked, with the estimated time.
struct QuickMarch {
    DrillingSettings settings;
    double seconds = 0;  ///< estimated computing time on a typical computer [s]
    /// Whether the sequence can be computed within the time allowed. Otherwise it has the minimum number of
    /// blows, and the window computes it only on request.
    bool isWithinTime = true;
};

/// Returns the settings of windowSettingsOf(), with the number of blows reduced to what fits into `seconds`
/// [s], but not below 100. Requires that drillingRefusals() is empty.
QuickMarch quickMarchOf(const Scenario& scenario, double seconds = 1);

}  // namespace drillwave
