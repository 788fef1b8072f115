// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the features of a curve from its fitted pieces.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/piecewise_fit.h"
#include "core/study/curve/curve_feature.h"
#include "core/study/curve/curve_range.h"

namespace drillwave {

/// Returns the same pieces of a curve, with the error of each sliver reduced to the larger error of its
/// neighbours. A sliver is a tiny piece around a kink or jump. Its own error, above the tolerance of the fit,
/// says nothing of the curve.
std::vector<FitPiece> limitSliverErrors(std::span<const FitPiece> pieces);

/// Returns the features of a curve, ascending in the parameter: global and local extremes, kinks, jumps and
/// crossings of `levels`. If a piece has several functions, the first one is used; its argument is the share
/// of `range`, 0 … 1. Empty if no piece has a result.
std::vector<CurveFeature> featuresOf(std::span<const FitPiece> pieces, const CurveRange& range,
                                     std::span<const double> levels);

}  // namespace drillwave
