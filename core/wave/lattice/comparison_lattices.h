// SPDX-License-Identifier: GPL-3.0-or-later
// Which coarser lattices tell how large the error of a lattice is.
#pragma once

#include <vector>

#include "core/wave/problem.h"

namespace drillwave {

/// Numbers of segments between about 0.4 N and 0.75 N, irregularly spread.
///
/// The error of a lattice depends on where in a step the hammer force jumps and the corners of the law fall,
/// so that it goes up and down as N grows, within limits that fall with N. A jump falls on the fraction
/// frac(N/τ) of a step, because all shapes jump at multiples of t0 only. Where that is 0 the lattice is much
/// more accurate, and the ones to compare it with are such too, if there are any near by; elsewhere they are
/// spread over all fractions.
std::vector<int> comparisonLattices(const Problem& problem, int segments);

}  // namespace drillwave
