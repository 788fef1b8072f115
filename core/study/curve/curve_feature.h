// SPDX-License-Identifier: GPL-3.0-or-later
// Features of a curve: minima, maxima, kinks, jumps and crossings of a level.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/numeric/estimate.h"

namespace drillwave {

/// Notable point of a curve, such as an extreme or a jump. Its position and value have error bounds that are
/// estimated from the accuracy of the curve.
struct CurveFeature {
    enum class Kind {
        minimum,   ///< local minimum, or the minimum over the whole range
        maximum,   ///< local maximum, or the maximum over the whole range
        kink,      ///< jump of the slope at a point that is neither minimum nor maximum
        jump,      ///< discontinuity of the value
        crossing,  ///< point where the curve passes through `level`
    };
    /// Local shape of the curve at the feature.
    enum class Shape {
        smooth,      ///< the curve is smooth here (or is only as irregular as its Kind says)
        cusp,        ///< the slope or the value jumps here
        end,         ///< the range, or the part of it with results, begins or ends here
        grid,        ///< the curve is solved only at points here; the position is uncertain by their spacing
        everywhere,  ///< the curve is constant over the whole range, within its errors
    };
    Kind kind = Kind::minimum;
    Shape shape = Shape::smooth;
    bool ofAll = false;  ///< whether this is the minimum or maximum of the whole line, not only a local one
    Estimate x = {};     ///< parameter value of the feature, in SI units
    /// Value of the output at the feature, in the unit of its column. At a jump, it is the value before the
    /// jump.
    Estimate value = {};
    double valueAfter = 0;  ///< output just after a jump, in the unit of its column; only used for jumps
    double level = 0;  ///< level that the curve crosses, in the unit of the output; only used for crossings
    bool rising = false;     ///< whether the output increases with x at a crossing; only used for crossings
    double slopeBefore = 0;  ///< slope just before a kink or cusp, in units of the output per SI unit of x
    /// Slope just after a kink or cusp, in units of the output per SI unit of x.
    double slopeAfter = 0;
    bool operator==(const CurveFeature&) const = default;
};

/// Returns the name of a kind: "minimum", "maximum", "kink", "jump" or "crossing".
std::string_view name(CurveFeature::Kind kind);
/// Returns the name of a shape: "smooth", "cusp", "end", "grid" or "everywhere".
std::string_view name(CurveFeature::Shape shape);

}  // namespace drillwave
