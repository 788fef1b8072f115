// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the blows that are tried with exponential sums; the others use power series from the start.
#pragma once

#include "core/wave/problem.h"

namespace drillwave {

/// Maximum number of corners (changes of slope) of the rock law for which ExponentialBasis is used; laws with
/// more corners use power series.
inline constexpr int mostCornersOfSums = 1;

/// Returns whether exponential sums (ExponentialBasis) are worth trying for a blow. They need few
/// reflections, clearly different slopes of the rock law, and rock that is not too soft. If not, power series
/// are used from the start.
bool suitsExponentials(const Problem& problem);

}  // namespace drillwave
