// SPDX-License-Identifier: GPL-3.0-or-later
// How large a section looks.
#pragma once

#include <cmath>
#include <numbers>

#include "core/model/drill_string.h"

namespace drillwave {

/// Outer diameter [m]; of a section given by its area that of a full bar.
inline double outerDiameter(const Section& section) {
    return section.area ? 2 * std::sqrt(*section.area / std::numbers::pi) : section.diameter;
}

}  // namespace drillwave
