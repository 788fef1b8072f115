// SPDX-License-Identifier: GPL-3.0-or-later
// Sequence of blows short enough to be computed within about a second.
#pragma once

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Work per second of one processor core of a typical computer [time steps × nodes; a node is an end of a
/// section]. Used to estimate computing times.
inline constexpr double workOfSecond = 2e7;

/// Returns the settings with which the window computes a sequence of blows. They are those of the scenario;
/// the default is 300 blows, of which 100 are transient. If the scenario has 300 or more transient blows, the
/// default is 1000 blows.
DrillingSettings windowSettingsOf(const Scenario& scenario);

/// Returns the request for the sequence of blows that the window computes automatically: the default results
/// without the Lyapunov exponent.
DrillingRequest quickWants();

/// Settings of a short sequence of blows that the window computes automatically, with the estimated time.
struct QuickMarch {
    DrillingSettings settings;
    double seconds = 0;  ///< estimated computing time on a typical computer [s]
    /// Whether the sequence can be computed within the permitted time. Otherwise it has the minimum number of
    /// blows, and the window computes it only on request.
    bool isWithinTime = true;
};

/// Returns the settings of windowSettingsOf(), but with fewer blows if they would take longer than `seconds`
/// [s]. The number of blows is not reduced below 100. Requires that drillingRefusals() is empty.
QuickMarch quickMarchOf(const Scenario& scenario, double seconds = 1);

}  // namespace drillwave
