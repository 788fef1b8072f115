// SPDX-License-Identifier: GPL-3.0-or-later
// Sequence of blows short enough to be computed within about a second.
#pragma once

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Work that one processor core of a typical computer does in a second [time steps × nodes].
inline constexpr double workOfSecond = 2e7;

/// Returns the settings with which the window computes a sequence of blows: as in the scenario, by default
/// 300 blows with 100 transient ones. The default is 1000 blows if the scenario has at least 300 transient
/// ones.
DrillingSettings windowSettingsOf(const Scenario& scenario);

/// Returns the request for a quick sequence of blows: penetration and gap with their errors, but no Lyapunov
/// exponent.
DrillingRequest quickWants();

/// Settings of a short sequence of blows that the window computes automatically, with the estimated time.
struct QuickMarch {
    DrillingSettings settings;
    double seconds = 0;  ///< estimated computing time on a typical computer [s]
    /// Whether the sequence can be computed within the time allowed. Otherwise it has the minimum number of
    /// blows, and the window computes it only on request.
    bool isWithinTime = true;
};

/// Returns the settings of windowSettingsOf() with fewer blows if they would take longer than `seconds` [s],
/// but at least 100 blows. Requires that drillingRefusals() is empty.
QuickMarch quickMarchOf(const Scenario& scenario, double seconds = 1);

}  // namespace drillwave
