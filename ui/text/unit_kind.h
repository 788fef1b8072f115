// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of values that people choose a unit for, and the units they are used to.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "core/model/parameter.h"

namespace drillwave {

enum class UnitSystem { dimensionless, si, us };

/// Finer than Quantity: a rod is measured in metres, what the bit does in millimetres.
enum class UnitKind {
    length,
    penetration,  ///< and other lengths across: diameters, gaps
    force,        ///< and thrust
    impulse,
    energy,
    power,
    stress,
    stiffness,
    time,
    speed,
    rate,  ///< of penetration
    frequency,
    area,
    modulus,
    density,
    mass,
    angle,
    attenuation,
    damping,
};

/// Units of kinds; a kind that is not in it has the units of the system.
using ChosenUnits = std::map<UnitKind, const Unit*>;

struct UnitKindRow {
    UnitKind kind;
    Quantity quantity;
    const char* name;   ///< what is kept in settings
    const char* label;  ///< in English, for a menu
    /// Units with prefixes if they help, from the largest to the smallest.
    std::span<const std::string_view> si;
    std::span<const std::string_view> us;
};

/// Returns the kinds in the order of a menu.
std::span<const UnitKindRow> unitKinds();
const UnitKindRow& rowOf(UnitKind kind);

/// The unit of the system in which a value of that size (SI) is best read: the largest that the size is not
/// less than one of, ten of in US units, or the smallest. A dimensionless `system` counts as SI.
const Unit& handyUnit(UnitKind kind, double size, UnitSystem system);

/// nullopt for a ratio.
std::optional<UnitKind> kindOf(const Parameter& parameter);

/// Returns the usual unit of a parameter in a system: for US units, one that suits its plausible values.
const Unit& customaryUnit(const Parameter& parameter, UnitSystem system);

}  // namespace drillwave
