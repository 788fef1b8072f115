// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_feature.h"

#include <array>

namespace drillwave {

std::string_view name(CurveFeature::Kind kind) {
    constexpr std::array<std::string_view, 5> names{"minimum", "maximum", "kink", "jump", "crossing"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view name(CurveFeature::Shape shape) {
    constexpr std::array<std::string_view, 5> names{"smooth", "cusp", "end", "grid", "everywhere"};
    return names[static_cast<std::size_t>(shape)];
}

}  // namespace drillwave
