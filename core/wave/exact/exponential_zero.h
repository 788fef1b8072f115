// SPDX-License-Identifier: GPL-3.0-or-later
// The first zero of an exponential sum: where an event ends a piece of contact or of free flight.
#pragma once

#include "core/wave/exact/exponential_sum.h"
#include "core/wave/exact/first_zero.h"

namespace drillwave {

/// How the searched function starts.
enum class SearchStart {
    anywhere,  ///< its value decides; rounding of zero counts as zero
    zero,      ///< zero by construction, whatever rounding says
};

/// First zero in (start, f.length] of f + c2 x², which is positive, or zero, at `start`: steps from a lower
/// bound of the curvature pass no zero, and once one is near beyond doubt Halley's method takes it. A function
/// that starts at zero and turns down has its zero at `start`.
///
/// Undecided where rounding hides what follows, and where very many steps do not suffice.
Zero<double> firstZero(const ExponentialSum& f, double c2, double start = 0,
                       SearchStart how = SearchStart::anywhere);

}  // namespace drillwave
