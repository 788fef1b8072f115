// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the blows that are tried with exponential sums; the others use power series from the start.
#pragma once

#include "core/wave/problem.h"

namespace drillwave {

/// Maximum number of corners of the rock law for which ExponentialBasis is used; laws with more corners use
/// power series.
inline constexpr int mostCornersOfSums = 1;

/// Returns whether ExponentialBasis is suitable for a blow: few reflections, distinct rates, and a rock that
/// is not too soft.
bool suitsExponentials(const Problem& problem);

}  // namespace drillwave
