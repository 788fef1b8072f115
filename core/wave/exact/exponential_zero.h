// SPDX-License-Identifier: GPL-3.0-or-later
// The first zero of an exponential sum: where an event ends a piece of contact or of free flight.
#pragma once

#include "core/numeric/first_zero.h"
#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Where a search begins, and what it may leave out.
struct Search {
    double start = 0;
    bool startsAtZero = false;  ///< by construction, whatever rounding says
    double negligible = 0;      ///< a function that stays below has no zero
};

/// Returns whether a formula gives the first zero of f: for up to three decays, all of one rate.
template <int lines>
bool hasZeroByFormula(const ExponentialSum<lines>& f);

/// First zero in (start, f.length] of f + c2 x², which is positive, or zero, at the start: steps from a lower
/// bound of the curvature pass no zero, and once one is near beyond doubt Halley's method takes it. A
/// function that starts at zero and turns down has its zero there.
///
/// Adds the search to `tally`. Undecided where rounding hides what follows, and where very many steps do not
/// suffice.
template <int lines>
Zero<double> firstZero(const ExponentialSum<lines>& f, double c2, const Search& search, SearchCount& tally);

}  // namespace drillwave
