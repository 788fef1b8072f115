// SPDX-License-Identifier: GPL-3.0-or-later
// Which blows are tried in closed form, and which are left to power series from the start.
#pragma once

#include "core/wave/problem.h"

namespace drillwave {

/// The corners of a law whose lines have rates of their own in ExponentialBasis; laws with more of them are
/// left to power series.
inline constexpr int mostCornersOfSums = 1;

/// Whether ExponentialBasis is worth trying: few reflections, rates apart, and a rock that is not too soft.
bool suitsExponentials(const Problem& problem);

}  // namespace drillwave
