// SPDX-License-Identifier: GPL-3.0-or-later
// A measured signal beside a computed one: put where it fits, as a recorder begins when it likes, and how far
// it is from it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/model/scenario.h"

namespace drillwave {

// A measured force over time, to be laid over a computed one.

enum class MeasuredQuantity {
    normalForce,  ///< N in a section of the rod or string, tension positive
    impactForce,  ///< F on the rock, compression positive
};

struct MeasuredSignal {
    std::string name;
    MeasuredQuantity quantity = MeasuredQuantity::normalForce;
    double place = 0;      ///< x from the struck end [m], below 0 in a hammer; of a normal force
    double timeShift = 0;  ///< [s] that is added to the times of the points
    TablePoints points;    ///< time [s], increasing, and force [N]
    double deviation = 0;  ///< of the samples from the lines between the points, at most [N]
    bool operator==(const MeasuredSignal&) const = default;
};

// Measured points are at least two of increasing times [s], joined by straight lines. The computed force is a
// function of time [s], looked at from 0 to `end` > 0.

/// Returns the shift of the times of the measured points [s] for which their product with the computed force,
/// integrated over time, is largest; either counts as 0 outside its own times. To a 2000th of the longer of
/// both, and between by a parabola. Nothing if the product never is positive.
std::optional<double> bestShift(const TablePoints& measured,
                                const std::function<double(double time)>& computed, double end);

/// Difference of a measured force from a computed one over the time that both have.
struct Misfit {
    double rms = 0;             ///< root of the mean square of their difference [N]
    double computedPeak = 0;    ///< size of the largest computed force, be it tension or compression [N]
    double peakDifference = 0;  ///< that of the measured one less that [N]
    std::optional<double>
        lag;  ///< how much later the measured one comes [s]: what bestShift() would take off
};

/// With `shift` [s] added to the times of the measured points; both are read at 2001 even times. Nothing
/// where they have no time in common.
std::optional<Misfit> misfitOf(const TablePoints& measured, double shift,
                               const std::function<double(double time)>& computed, double end);

}  // namespace drillwave
