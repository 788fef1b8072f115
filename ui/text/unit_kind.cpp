// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/unit_kind.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace drillwave {
namespace {

template <std::size_t count>
using Units = std::array<std::string_view, count>;

constexpr Units<1> metre{"m"}, foot{"ft"}, inch{"in"};
constexpr Units<3> small{"m", "mm", "um"};
constexpr Units<4> newton{"GN", "MN", "kN", "N"};
constexpr Units<2> pound{"kip", "lbf"};
constexpr Units<3> newtonSecond{"MN s", "kN s", "N s"};
constexpr Units<1> poundSecond{"lbf s"};
constexpr Units<4> joule{"MJ", "kJ", "J", "mJ"};
constexpr Units<1> footPound{"ft lbf"};
constexpr Units<3> watt{"MW", "kW", "W"};
constexpr Units<1> horsePower{"hp"};
constexpr Units<3> pascal{"MPa", "kPa", "Pa"};
constexpr Units<2> psi{"ksi", "psi"};
constexpr Units<4> newtonPerMetre{"GN/m", "MN/m", "kN/m", "N/m"};
constexpr Units<2> poundPerInch{"kip/in", "lbf/in"};
constexpr Units<4> second{"s", "ms", "us", "ns"};
constexpr Units<1> metrePerSecond{"m/s"}, footPerSecond{"ft/s"};
constexpr Units<1> metrePerMinute{"m/min"}, footPerMinute{"ft/min"};
constexpr Units<1> hertz{"Hz"}, blowsPerMinute{"bpm"};
constexpr Units<1> squareMillimetre{"mm^2"}, squareInch{"in^2"};
constexpr Units<1> gigapascal{"GPa"}, megapsi{"Mpsi"};
constexpr Units<1> kilogram{"kg"}, poundMass{"lb"}, degree{"deg"};
constexpr Units<1> perMetre{"1/m"}, perFoot{"1/ft"};
constexpr Units<3> newtonSecondPerMetre{"MN s/m", "kN s/m", "N s/m"};
constexpr Units<1> poundSecondPerInch{"lbf s/in"};
constexpr Units<1> kilogramPerVolume{"kg/m^3"}, poundPerVolume{"lb/ft^3"};

constexpr UnitKindRow rows[] = {
    {UnitKind::length, Quantity::length, "length", QT_TRANSLATE_NOOP("UnitKind", "length of the rod"), metre,
     foot},
    {UnitKind::penetration, Quantity::length, "penetration",
     QT_TRANSLATE_NOOP("UnitKind", "penetration, gap, diameter"), small, inch},
    {UnitKind::force, Quantity::force, "force", QT_TRANSLATE_NOOP("UnitKind", "force, thrust"), newton,
     pound},
    {UnitKind::impulse, Quantity::impulse, "impulse", QT_TRANSLATE_NOOP("UnitKind", "impulse"), newtonSecond,
     poundSecond},
    {UnitKind::energy, Quantity::energy, "energy", QT_TRANSLATE_NOOP("UnitKind", "energy"), joule, footPound},
    {UnitKind::power, Quantity::power, "power", QT_TRANSLATE_NOOP("UnitKind", "power"), watt, horsePower},
    {UnitKind::stress, Quantity::stress, "stress", QT_TRANSLATE_NOOP("UnitKind", "stress"), pascal, psi},
    {UnitKind::stiffness, Quantity::stiffness, "stiffness", QT_TRANSLATE_NOOP("UnitKind", "stiffness"),
     newtonPerMetre, poundPerInch},
    {UnitKind::time, Quantity::time, "time", QT_TRANSLATE_NOOP("UnitKind", "time"), second, second},
    {UnitKind::speed, Quantity::velocity, "speed", QT_TRANSLATE_NOOP("UnitKind", "speed"), metrePerSecond,
     footPerSecond},
    {UnitKind::rate, Quantity::velocity, "rate", QT_TRANSLATE_NOOP("UnitKind", "penetration rate"),
     metrePerMinute, footPerMinute},
    {UnitKind::frequency, Quantity::frequency, "frequency", QT_TRANSLATE_NOOP("UnitKind", "blow frequency"),
     hertz, blowsPerMinute},
    {UnitKind::area, Quantity::area, "area", QT_TRANSLATE_NOOP("UnitKind", "area"), squareMillimetre,
     squareInch},
    {UnitKind::modulus, Quantity::stress, "modulus", QT_TRANSLATE_NOOP("UnitKind", "Young's modulus"),
     gigapascal, megapsi},
    {UnitKind::density, Quantity::density, "density", QT_TRANSLATE_NOOP("UnitKind", "density"),
     kilogramPerVolume, poundPerVolume},
    {UnitKind::mass, Quantity::mass, "mass", QT_TRANSLATE_NOOP("UnitKind", "mass"), kilogram, poundMass},
    {UnitKind::angle, Quantity::angle, "angle", QT_TRANSLATE_NOOP("UnitKind", "angle"), degree, degree},
    {UnitKind::attenuation, Quantity::attenuation, "attenuation",
     QT_TRANSLATE_NOOP("UnitKind", "attenuation"), perMetre, perFoot},
    {UnitKind::damping, Quantity::damping, "damping", QT_TRANSLATE_NOOP("UnitKind", "damping"),
     newtonSecondPerMetre, poundSecondPerInch},
};

// Thousands of pounds are usual: the step to kips comes a decade late.
constexpr double usStep = 10;

}  // namespace

std::span<const UnitKindRow> unitKinds() {
    return rows;
}

const UnitKindRow& rowOf(UnitKind kind) {
    return *std::ranges::find(rows, kind, &UnitKindRow::kind);
}

const Unit& handyUnit(UnitKind kind, double size, UnitSystem system) {
    const UnitKindRow& row = rowOf(kind);
    const auto names = system == UnitSystem::us ? row.us : row.si;
    const double step = names.data() == row.si.data() ? 1 : usStep;
    const Unit* chosen = nullptr;
    for (const std::string_view name : names) {
        chosen = findUnit(row.quantity, name);
        assert(chosen);
        if (size >= chosen->factor() * step) break;
    }
    return *chosen;
}

std::optional<UnitKind> kindOf(const Parameter& parameter) {
    switch (parameter.quantity) {
        case Quantity::length:
            return parameter.unit == "m" ? UnitKind::length : UnitKind::penetration;
        case Quantity::stress:
            return parameter.unit == "GPa" ? UnitKind::modulus : UnitKind::stress;
        default:
            break;
    }
    const auto found = std::ranges::find(rows, parameter.quantity, &UnitKindRow::quantity);
    return found == std::end(rows) ? std::nullopt : std::optional(found->kind);
}

const Unit& customaryUnit(const Parameter& parameter, UnitSystem system) {
    const std::optional<UnitKind> kind = kindOf(parameter);
    if (!kind || system != UnitSystem::us) return parameter.displayUnit();
    const UnitKindRow& row = rowOf(*kind);
    // A kind with the same units in both systems keeps the prefix of the table of parameters.
    if (row.us.data() == row.si.data()) return parameter.displayUnit();
    const double middle = std::sqrt(parameter.plausible.low * parameter.plausible.high);
    return handyUnit(*kind, middle, system);
}

}  // namespace drillwave
