// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario.h"

#include <algorithm>
#include <array>

namespace drillwave {
namespace {

/// In the order of PulseShape.
constexpr std::array<std::string_view, 8> shapeNames{"rectangular", "triangular", "half_sine", "trapezoid",
                                                     "exponential", "piston",     "table",     "rigid_body"};

}  // namespace

std::string_view name(PulseShape shape) {
    return shapeNames[static_cast<std::size_t>(shape)];
}

std::optional<PulseShape> findPulseShape(std::string_view name) {
    const auto found = std::ranges::find(shapeNames, name);
    if (found == shapeNames.end()) return std::nullopt;
    return static_cast<PulseShape>(found - shapeNames.begin());
}

std::span<const std::string_view> pulseShapeNames() {
    return shapeNames;
}

}  // namespace drillwave
