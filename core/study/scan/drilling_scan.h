// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences of blows for several values of a parameter, each started from rest and from bouncing (drilling
// §5).
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/drilling/drilling_study.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// Sequence of blows at one value of the parameter and with one initial state.
struct DrillingScanPoint {
    double value = 0;  ///< value of the parameter, in SI units
    DrillingStart start = DrillingStart::rest;
    DrillingResult result;
};

struct DrillingScan {
    Scenario base;
    SweepAxis axis;
    DrillingSettings settings;
    /// Sequences of blows in the order of the values. For each value there is a sequence that starts from
    /// rest. One that starts from bouncing follows if it differs by more than the errors.
    std::vector<DrillingScanPoint> points;
    /// Number of blows of all sequences that start from bouncing. At each value the computation stops as soon
    /// as this sequence agrees with the one from rest.
    long bouncingBlows = 0;
    /// Coefficient of restitution e of a blow from rest without a gap, for the first value. In a scan of the
    /// feed force it applies to all values.
    std::optional<double> cor = {};
    double runTime = 0;
    /// Reason from scanRefusals() why the scan cannot run; there are then no points. Empty otherwise.
    Message refusal = {};
};

struct DrillingScanWork {
    int jobs = 1;
    double mostWork = mostDrillingWork;  ///< maximum work of each sequence of blows [cells × nodes]
    bool lyapunov = false;               ///< whether to compute the Lyapunov exponent λ of every motion
    std::stop_token stop = {};
    DrillingProgress progress = {};
    /// Callback, called after every value with the scan so far.
    std::function<void(const DrillingScan&)> onValue = {};
};

/// Returns why sequences of blows cannot be computed for some values of the axis; empty if all can.
std::vector<Message> scanRefusals(const Scenario& base, const SweepAxis& axis,
                                  const DrillingSettings& settings);

/// Returns the maximum work of one value of the parameter [cells × nodes], including the Lyapunov exponent.
double scanWork(const Scenario& scenario, const DrillingSettings& settings);

/// Returns the sequences of blows for all values of the axis, computed in parallel. Results do not depend on
/// the number of threads. After a stop request the result must not be used.
DrillingScan scanDrilling(const Scenario& base, const SweepAxis& axis, const DrillingSettings& settings,
                          const DrillingScanWork& work);

}  // namespace drillwave
