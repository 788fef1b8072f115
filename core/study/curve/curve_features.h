// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a curve, from its pieces.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/piecewise_fit.h"
#include "core/study/curve/curve_feature.h"
#include "core/study/curve/curve_range.h"

namespace drillwave {

/// Returns the pieces with values of slivers limited by their neighbours: within a jump any value is
/// possible, but none beyond its ends.
std::vector<FitPiece> mergeSlivers(std::span<const FitPiece> pieces);

/// Features by place, of the first function of pieces over shares of the range: the least and the largest and
/// all local ones, kinks, jumps, and where the levels are crossed. None where there is no answer at all.
std::vector<CurveFeature> featuresOf(std::span<const FitPiece> pieces, const CurveRange& range,
                                     std::span<const double> levels);

}  // namespace drillwave
