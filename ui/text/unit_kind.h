// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of quantity for which a unit can be chosen, and their usual units.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "core/model/parameter.h"

namespace drillwave {

enum class UnitSystem { dimensionless, si, us };

/// Kind of quantity for which a unit can be chosen. It is finer than Quantity: rod lengths are in metres,
/// penetrations in millimetres, although both are lengths.
enum class UnitKind {
    length,
    penetration,  ///< penetrations and other small lengths: diameters, gaps
    force,        ///< forces, including feed forces
    impulse,
    energy,
    power,
    stress,
    stiffness,
    time,
    speed,
    rate,  ///< penetration rate
    frequency,
    area,
    modulus,
    density,
    mass,
    angle,
    attenuation,
    damping,
};

/// Units that the user has chosen for single kinds of quantity. Kinds without an entry have the units of the
/// system, such as SI.
using ChosenUnits = std::map<UnitKind, const Unit*>;

struct UnitKindRow {
    UnitKind kind;
    Quantity quantity;
    const char* name;   ///< name in the stored settings
    const char* label;  ///< English label in the menu of units
    /// SI units of the kind, with prefixes if useful, from the largest to the smallest.
    std::span<const std::string_view> si;
    /// US units of the kind, from the largest to the smallest.
    std::span<const std::string_view> us;
};

/// Returns all kinds of quantity with their units, in the order in which a menu lists them.
std::span<const UnitKindRow> unitKinds();
const UnitKindRow& rowOf(UnitKind kind);

/// Returns the unit in which a value of magnitude `size` (SI) is best read. It is the largest unit that gives
/// a number of at least one (in US units ten), else the smallest. A dimensionless `system` counts as SI.
const Unit& handyUnit(UnitKind kind, double size, UnitSystem system);

/// Returns the kind of quantity of a parameter; nothing for a ratio.
std::optional<UnitKind> kindOf(const Parameter& parameter);

/// Returns the usual unit of a parameter in a system of units; for US units, one that suits its typical
/// values.
const Unit& customaryUnit(const Parameter& parameter, UnitSystem system);

}  // namespace drillwave
