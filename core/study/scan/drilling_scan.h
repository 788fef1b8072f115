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
    /// rest. A sequence that starts from bouncing follows only if its results differ from those from rest by
    /// more than the errors.
    std::vector<DrillingScanPoint> points;
    /// Number of computed blows in all sequences that start from bouncing. At each value, such a sequence
    /// stops as soon as it agrees with the one from rest.
    long bouncingBlows = 0;
    /// Coefficient of restitution e of a single blow from rest without a gap, at the first value of the
    /// scanned parameter. If the scanned parameter is the feed force, e is the same for all its values.
    /// Empty if not known.
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
    /// Callback, called after every value of the scanned parameter with the scan so far.
    std::function<void(const DrillingScan&)> onValue = {};
};

/// Returns why sequences of blows cannot be computed at the smallest or largest value of the axis, or at any
/// of its words. Empty if they can; values between are not checked.
std::vector<Message> scanRefusals(const Scenario& base, const SweepAxis& axis,
                                  const DrillingSettings& settings);

/// Returns the estimated work for one value of a scanned parameter [time steps × nodes], so that scans that
/// take too long can be refused. It is the work of a sequence from rest, with its error and Lyapunov
/// exponent, and of one from bouncing.
double scanWork(const Scenario& scenario, const DrillingSettings& settings);

/// Returns the sequences of blows for all values of the axis, computed in parallel. Results do not depend on
/// the number of threads. After a stop request the result must not be used.
DrillingScan scanDrilling(const Scenario& base, const SweepAxis& axis, const DrillingSettings& settings,
                          const DrillingScanWork& work);

}  // namespace drillwave
