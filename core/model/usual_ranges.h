// SPDX-License-Identifier: GPL-3.0-or-later
// The plausible ranges of what rods, hammers and sections are all made of. Outside a value is remarked on.
#pragma once

#include "core/model/parameter.h"

namespace drillwave::usual_ranges {

inline constexpr Range modulus{60e9, 250e9};           // [Pa] aluminium to steel, with some room
inline constexpr Range density{2500, 9000};            // [kg/m³] likewise
inline constexpr Range yieldStrength{200e6, 2000e6};   // [Pa]
inline constexpr Range fatigueStrength{50e6, 1500e6};  // [Pa]

}  // namespace drillwave::usual_ranges
