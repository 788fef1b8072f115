// SPDX-License-Identifier: GPL-3.0-or-later
// A measured signal beside a computed one: put where it fits, as a recorder begins when it likes, and how far
// it is from it.
#pragma once

#include <functional>
#include <optional>

#include "core/model/table_points.h"

namespace drillwave {

// Measured points are at least two of increasing times [s], joined by straight lines. The computed force is a
// function of time [s], looked at from 0 to `end` > 0.

/// What to add to the times of the measured points [s] so that their product with the computed force,
/// integrated over time, is largest; either counts as 0 outside of its own times. To a 2000th of the longer
/// of both, and between by a parabola. Nothing where the product never is positive.
std::optional<double> bestShift(const TablePoints& measured,
                                const std::function<double(double time)>& computed, double end);

/// How far a measured force is from a computed one over the time that both have.
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
