// SPDX-License-Identifier: GPL-3.0-or-later
// Allowed ranges of the numbers of hammers, drill strings and rock drills, in one table. They are far wider
// than anything in use, but products of five such numbers, as the force of a blow, stay within double
// precision.
#pragma once

#include "core/model/parameter.h"

namespace drillwave::string_ranges {

inline constexpr Range length{1e-6, 1e5};    // length of a section [m]
inline constexpr Range diameter{1e-6, 1e3};  // outer diameter of a section [m]
inline constexpr Range bore{0, 1e3};         // diameter of the flushing hole of a section [m]
inline constexpr Range area{1e-12, 1e6};     // cross-section of a section [m²]
inline constexpr Range modulus{1e3, 1e15};   // Young's modulus [Pa]
inline constexpr Range density{1e-3, 1e6};   // density [kg/m³]
inline constexpr Range mass{0, 1e9};         // mass lumped at the end of a section [kg]
/// Allowed range of a wave loss: the share of the energy of a wave that is lost in a joint, from 0 to below
/// 1.
inline constexpr Range share{0, 1, false, translatable("a section that loses everything carries no wave"),
                             true};
inline constexpr Range attenuation{0, 1e6};    // decay of the amplitude of a wave per length [1/m]
inline constexpr Range strength{1, 1e15};      // yield or fatigue strength [Pa]
inline constexpr Range velocity{1e-6, 1e5};    // impact velocity of the hammer [m/s]
inline constexpr Range stiffness{1, 1e18};     // stiffness of the hammer face and of the rock [N/m]
inline constexpr Range endTime{0, 1e6, true};  // time at which the simulation of the blow ends [s]

}  // namespace drillwave::string_ranges

/// Allowed ranges of the operating data of the rock drill.
namespace drillwave::drill_ranges {

inline constexpr Range frequency{1e-6, 1e9};  // blow frequency [Hz]
inline constexpr Range thrust{0, 1e15};       // installed feed force [N]
inline constexpr Range mass{0, 1e12};         // mass of the machine [kg]
inline constexpr Range damping{0, 1e18};      // dashpot between machine and rear end [N s/m]
inline constexpr Range stiffness{0, 1e18};    // spring between machine and rear end [N/m]

}  // namespace drillwave::drill_ranges

/// Typical ranges for materials of rods, hammers and sections. A value outside raises a warning.
namespace drillwave::usual_ranges {

// Young's modulus [Pa], aluminium to steel with a margin
inline constexpr Range modulus{60e9, 250e9};
inline constexpr Range density{2500, 9000};            // density [kg/m³], aluminium to steel with a margin
inline constexpr Range yieldStrength{200e6, 2000e6};   // yield strength [Pa]
inline constexpr Range fatigueStrength{50e6, 1500e6};  // fatigue strength [Pa]

}  // namespace drillwave::usual_ranges
