// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_feature.h"

#include "core/text/enum_names.h"

namespace drillwave {

std::string_view name(CurveFeature::Kind kind) {
    using enum CurveFeature::Kind;
    static constexpr EnumNames<CurveFeature::Kind> names{
        {{minimum, "minimum"}, {maximum, "maximum"}, {kink, "kink"}, {jump, "jump"}, {crossing, "crossing"}}};
    return names[kind];
}

std::string_view name(CurveFeature::Shape shape) {
    using enum CurveFeature::Shape;
    static constexpr EnumNames<CurveFeature::Shape> names{
        {{smooth, "smooth"}, {cusp, "cusp"}, {end, "end"}, {grid, "grid"}, {everywhere, "everywhere"}}};
    return names[shape];
}

}  // namespace drillwave
