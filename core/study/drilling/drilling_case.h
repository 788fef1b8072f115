// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares a scenario for a sequence of blows: settings, checks and units (drilling §1 – §4).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/blow/drill_problems.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

/// Settings of a sequence of blows: number of blows, size of the cells (time steps), and initial state.
struct DrillingSettings {
    long blows = 1000;  ///< N, number of blows to compute
    long settle = 200;  ///< number of transient blows at the start, which the statistics exclude
    int cells = 40;     ///< number of cells (time steps) per duration t0 of the hammer force
    DrillingStart start = DrillingStart::rest;
    bool operator==(const DrillingSettings&) const = default;
};

inline constexpr int leastDrillingCells = 10, mostDrillingCells = 400, scanCells = 20;
inline constexpr long mostBlows = 1'000'000;

/// Returns the settings that a scenario specifies for a sequence of blows. If it specifies none, there are
/// `usualBlows` blows, one fifth of them transient.
DrillingSettings drillingSettingsOf(const Scenario& scenario, long usualBlows = 1000);

/// Returns the settings for the sequences of blows in a scan, one sequence for each value of a parameter. To
/// be fast, the time step is twice the default, and there are 300 blows unless the scenario specifies more or
/// fewer (see scanLengthOf()).
DrillingSettings scanSettingsOf(const Scenario& scenario);

/// Returns why a sequence of blows cannot be computed, one message for each cause, such as "drill.thrust: is
/// missing …". Empty if it can.
std::vector<Message> drillingRefusals(const Scenario& scenario, const DrillingSettings& settings);

/// Units of a dimensionless Problem, with their values in SI.
struct DrillingUnits {
    double time = 1;      ///< unit of time: t0, duration of the hammer force [s]
    double force = 1;     ///< unit of force: F0, mean hammer force [N]
    double velocity = 1;  ///< unit of velocity: F0/Zr, with Zr the reference impedance of the Problem [m/s]
    double length() const { return velocity * time; }
    double impulse() const { return force * time; }
    double energy() const { return force * length(); }
};
/// Returns the SI values of the units that a dimensionless Problem of this scenario uses.
DrillingUnits drillingUnitsOf(const Scenario& scenario);

/// Returns the dimensionless problem of a sequence of blows. `blow` is the problem of a single blow of the
/// scenario, in which conical sections are already divided into uniform pieces. Requires that
/// drillingRefusals() is empty.
DrillingProblem drillingProblemOf(const Scenario& scenario, Problem blow);

}  // namespace drillwave
