// SPDX-License-Identifier: GPL-3.0-or-later
// Features of a curve: minimum and maximum, turns, jumps and crossings of a level.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/numeric/estimate.h"

namespace drillwave {

/// Place of a curve, with errors as estimated from the accuracy of the curve.
struct CurveFeature {
    enum class Kind {
        minimum,   ///< least of a neighbourhood, or of the range
        maximum,   ///< largest of a neighbourhood, or of the range
        kink,      ///< the slope jumps, and it is no extreme
        jump,      ///< the value jumps
        crossing,  ///< `level` is passed
    };
    /// Shape of the curve at the feature.
    enum class Shape {
        smooth,      ///< no more than the kind says
        cusp,        ///< the slope jumps, or the value does
        end,         ///< the range, or the known part of it, begins or ends here
        grid,        ///< the curve is only known at points here, and the place within their distance
        everywhere,  ///< the curve is the same everywhere, within errors
    };
    Kind kind = Kind::minimum;
    Shape shape = Shape::smooth;
    bool ofAll = false;      ///< the least or largest of the whole line
    Estimate x = {};         ///< SI
    Estimate value = {};     ///< in the unit of the output column; of a jump the value before it
    double valueAfter = 0;   ///< of a jump
    double level = 0;        ///< of a crossing
    bool rising = false;     ///< of a crossing: with growing x
    double slopeBefore = 0;  ///< of a kink or cusp, per unit of x (SI)
    double slopeAfter = 0;
    bool operator==(const CurveFeature&) const = default;
};

/// "minimum", "maximum", "kink", "jump", "crossing".
std::string_view name(CurveFeature::Kind kind);
/// "smooth", "cusp", "end", "grid", "everywhere".
std::string_view name(CurveFeature::Shape shape);

}  // namespace drillwave
