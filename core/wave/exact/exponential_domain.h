// SPDX-License-Identifier: GPL-3.0-or-later
// Which blows are tried in closed form, and which are left to power series from the start.
#pragma once

#include "core/wave/problem.h"

namespace drillwave {

/// Maximum number of corners whose lines have rates of their own in ExponentialBasis; laws with more corners
/// are left to power series.
inline constexpr int mostCornersOfSums = 1;

/// Returns whether ExponentialBasis suits: few reflections, distinct rates, and a rock that is not too soft.
bool suitsExponentials(const Problem& problem);

}  // namespace drillwave
