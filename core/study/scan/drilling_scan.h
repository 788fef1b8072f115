// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows over the values of a parameter, each from rest and from bouncing (drilling §5).
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/drilling/drilling_study.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// The march at one value.
struct DrillingScanPoint {
    double value = 0;  ///< SI
    DrillingStart start = DrillingStart::rest;
    DrillingResult result;
};

struct DrillingScan {
    Scenario base;
    SweepAxis axis;
    DrillingSettings settings;
    /// In the order of the values; for each from rest, and also from bouncing if that differs by more than
    /// the errors.
    std::vector<DrillingScanPoint> points;
    long bouncingBlows = 0;  ///< marched from bouncing: none after both starts agree
    /// e of the blow from rest without a gap, for the first value; for all values when scanning the thrust.
    std::optional<double> cor = {};
    double runTime = 0;
    Message refusal = {};  ///< the scanRefusals(), where there are any: no points then
};

struct DrillingScanWork {
    int jobs = 1;
    double mostWork = mostDrillingWork;  ///< of each march [cells times nodes]
    bool lyapunov = false;               ///< also compute λ of every motion
    std::stop_token stop = {};
    DrillingProgress progress = {};
    /// Called after every value with the scan so far.
    std::function<void(const DrillingScan&)> onValue = {};
};

/// Returns why values of the axis cannot be drilled with; empty if all can.
std::vector<Message> scanRefusals(const Scenario& base, const SweepAxis& axis,
                                  const DrillingSettings& settings);

/// Returns the maximum work of a value [cells × nodes], including λ.
double scanWork(const Scenario& scenario, const DrillingSettings& settings);

/// Marches values side by side; results do not depend on the number of threads. After a stop they must not be
/// used.
DrillingScan scanDrilling(const Scenario& base, const SweepAxis& axis, const DrillingSettings& settings,
                          const DrillingScanWork& work);

}  // namespace drillwave
