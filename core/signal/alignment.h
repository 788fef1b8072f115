// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of a measured signal with a computed one: the time shift at which they agree best, since
// recorders start at any time, and their difference.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/model/scenario.h"

namespace drillwave {

// Measured force over time, to be drawn over a computed one.

enum class MeasuredQuantity {
    normalForce,  ///< normal force N in a section of the rod or string [N], tension positive
    impactForce,  ///< impact force F on the rock [N], compression positive
};

struct MeasuredSignal {
    std::string name;
    MeasuredQuantity quantity = MeasuredQuantity::normalForce;
    double place = 0;      ///< position x of a normal force from the struck end [m], negative in a hammer
    double timeShift = 0;  ///< shift that is added to the times of the points [s]
    TablePoints points;    ///< time [s], increasing, and force [N]
    double deviation = 0;  ///< largest distance of the recorded samples from the lines between the points [N]
    bool operator==(const MeasuredSignal&) const = default;
};

// Measured points are at least two, with increasing times [s], joined by straight lines. The computed force
// is a function of time [s] from 0 to `end` > 0.

/// Returns the time shift [s] of the measured points at which measured and computed force agree best: the
/// integral of their product is largest. Outside its own times each force is 0. The shift is found in steps
/// of 1/2000 of the longer record, and refined by a parabola. Returns nullopt if the integral is never
/// positive.
std::optional<double> bestShift(const TablePoints& measured,
                                const std::function<double(double time)>& computed, double end);

/// Difference between a measured and a computed force over their common time.
struct Misfit {
    double rms = 0;           ///< root mean square of the difference [N]
    double computedPeak = 0;  ///< largest absolute value of the computed force, tension or compression [N]
    /// Largest absolute value of the measured force minus that of the computed one [N].
    double peakDifference = 0;
    /// Delay of the measured force [s] relative to the position at which it agrees best with the computed
    /// one: the given shift minus the result of bestShift(). Empty if bestShift() finds none.
    std::optional<double> lag;
};

/// Returns the difference between a measured and a computed force at 2001 equally spaced times. Adds `shift`
/// [s] to the times of the measured points before the comparison. Returns nullopt if the two forces have no
/// time in common.
std::optional<Misfit> misfitOf(const TablePoints& measured, double shift,
                               const std::function<double(double time)>& computed, double end);

}  // namespace drillwave
