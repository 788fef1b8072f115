// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of hard ranges of hammers, strings and rock drills. They are far wider than all that is
// drilled with, and so narrow that no product of them leaves double precision: the force of a blow is one of
// five.
#pragma once

#include "core/model/parameter.h"

namespace drillwave::string_ranges {

inline constexpr Range length{1e-6, 1e5};    // [m]
inline constexpr Range diameter{1e-6, 1e3};  // [m]
inline constexpr Range bore{0, 1e3};         // [m]
inline constexpr Range area{1e-12, 1e6};     // [m²]
inline constexpr Range modulus{1e3, 1e15};   // [Pa]
inline constexpr Range density{1e-3, 1e6};   // [kg/m³]
inline constexpr Range mass{0, 1e9};         // [kg]
/// Share of the energy of a wave.
inline constexpr Range share{0, 1, false, translatable("a section that loses everything carries no wave"),
                             true};
inline constexpr Range attenuation{0, 1e6};    // [1/m]
inline constexpr Range strength{1, 1e15};      // [Pa]
inline constexpr Range velocity{1e-6, 1e5};    // [m/s]
inline constexpr Range stiffness{1, 1e18};     // [N/m] of the face and of the rock
inline constexpr Range endTime{0, 1e6, true};  // [s]

}  // namespace drillwave::string_ranges

/// Hard ranges of the rock drill.
namespace drillwave::drill_ranges {

inline constexpr Range frequency{1e-6, 1e9};  // [Hz]
inline constexpr Range thrust{0, 1e15};       // [N]
inline constexpr Range mass{0, 1e12};         // [kg]
inline constexpr Range damping{0, 1e18};      // [N s/m]
inline constexpr Range stiffness{0, 1e18};    // [N/m]

}  // namespace drillwave::drill_ranges

/// The plausible ranges of what rods, hammers and sections are all made of. Outside a value is remarked on.
namespace drillwave::usual_ranges {

inline constexpr Range modulus{60e9, 250e9};           // [Pa] aluminium to steel, with some room
inline constexpr Range density{2500, 9000};            // [kg/m³] likewise
inline constexpr Range yieldStrength{200e6, 2000e6};   // [Pa]
inline constexpr Range fatigueStrength{50e6, 1500e6};  // [Pa]

}  // namespace drillwave::usual_ranges
