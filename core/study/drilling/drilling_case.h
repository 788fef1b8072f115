// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario as a march of many blows: what it needs, what it refuses, its units (drilling §1 – §4).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/blow/drill_problems.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

/// Number of blows, and fineness of cells.
struct DrillingSettings {
    long blows = 1000;  ///< N
    long settle = 200;  ///< the first of them that no statistic counts
    int cells = 40;     ///< per t0
    DrillingStart start = DrillingStart::rest;
    bool operator==(const DrillingSettings&) const = default;
};

inline constexpr int leastDrillingCells = 10, mostDrillingCells = 400, scanCells = 20;
inline constexpr long mostBlows = 1'000'000;

/// Returns the settings of the scenario; by default `usualBlows`, a fifth of them transient.
DrillingSettings drillingSettingsOf(const Scenario& scenario, long usualBlows = 1000);

/// Returns the settings for a study of many values (scanLengthOf()).
DrillingSettings scanSettingsOf(const Scenario& scenario);

/// Returns why a scenario cannot be drilled with, each with its key: "drill.thrust: is missing …". Empty if
/// it can be.
std::vector<Message> drillingRefusals(const Scenario& scenario, const DrillingSettings& settings);

/// SI values of the units of a Problem.
struct DrillingUnits {
    double time = 1;      ///< t0
    double force = 1;     ///< F0
    double velocity = 1;  ///< F0/Zr
    double length() const { return velocity * time; }
    double impulse() const { return force * time; }
    double energy() const { return force * length(); }
};
DrillingUnits drillingUnitsOf(const Scenario& scenario);

/// The march of a scenario that has no drillingRefusals(). `blow` is its blow, with the pieces of its cones.
DrillingProblem drillingProblemOf(const Scenario& scenario, Problem blow);

}  // namespace drillwave
