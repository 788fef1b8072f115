// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the features of a curve from its fitted pieces.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/piecewise_fit.h"
#include "core/study/curve/curve_feature.h"
#include "core/study/curve/curve_range.h"

namespace drillwave {

/// Returns a copy of the pieces of a curve with more realistic error bounds for slivers, tiny pieces around a
/// kink or jump. The stated error of a sliver is large because no polynomial fits there. It is reduced to the
/// larger error of the two neighbouring pieces.
std::vector<FitPiece> limitSliverErrors(std::span<const FitPiece> pieces);

/// Returns the features of a curve, ascending in the parameter: global and local extremes, kinks, jumps and
/// crossings of `levels`. If pieces have functions for several outputs, those of the first output are used.
/// Their argument is the share 0 … 1 of `range`. Empty if no piece has a result.
std::vector<CurveFeature> featuresOf(std::span<const FitPiece> pieces, const CurveRange& range,
                                     std::span<const double> levels);

}  // namespace drillwave
