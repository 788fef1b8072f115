// SPDX-License-Identifier: GPL-3.0-or-later
// First zero of an exponential sum, where an event ends a piece of contact or of free flight.
#pragma once

#include "core/numeric/first_zero.h"
#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Start of the search for a zero of an exponential sum, and the values that count as no zero.
struct Search {
    /// Start of the search within the interval, in units of t0.
    double start = 0;
    /// Whether the function is exactly zero at the start of the search, even if its computed value differs by
    /// rounding.
    bool startsAtZero = false;
    /// Magnitude up to which values of the function count as rounding, in the unit of the function. A
    /// function that stays so small has no zero.
    double negligible = 0;
};

/// Returns whether the first zero of f follows from a formula, without a search. This requires that f
/// consists only of at most three decays e^(−λx) (λx)^m/m! (m ≤ 2) of one rate λ.
template <int lines>
bool hasZeroByFormula(const ExponentialSum<lines>& f);

/// Returns the first zero in (start, f.length] of f + c2 x², which must be ≥ 0 at the start. Steps from a
/// lower bound of the curvature never pass a zero; once a zero is certainly near, Halley's method finds it.
/// If f is zero at the start and then decreases, the result is the start.
///
/// The effort of the search is added to `tally`. The result is undecided if rounding hides the sign, or if
/// the number of steps reaches its limit.
template <int lines>
Zero<double> firstZero(const ExponentialSum<lines>& f, double c2, const Search& search, SearchCount& tally);

}  // namespace drillwave
