// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_units.h"

#include <cmath>

#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

// Shown magnitudes that need no other prefix.
constexpr double leastReadable = 0.1;
constexpr double mostReadable = 1e4;

}  // namespace

UnitSystem naturalUnits(const Scenario& scenario) {
    return hasUnits(scenario) ? UnitSystem::si : UnitSystem::dimensionless;
}

QString ShownUnit::axisLabel(const QString& words) const {
    if (unit.isEmpty()) return words;
    return dimensionless ? QStringLiteral("%1 / %2").arg(words, unit)
                         : QStringLiteral("%1 [%2]").arg(words, unit);
}

ShownUnit shownUnit(const Unit& unit) {
    return {unit.fromSi(1), shownUnitName(unit.name), false};
}

ShownUnit readable(const ShownUnit& unit, double value) {
    const double shown = std::abs(value * unit.factor);
    if (!unit.prefixes || shown == 0 || (shown >= leastReadable && shown < mostReadable)) return unit;
    const auto& [kind, system, present] = *unit.prefixes;
    const Unit& better = handyUnit(kind, present->toSi(shown), system);
    ShownUnit result = unit;
    result.factor = better.fromSi(present->toSi(unit.factor));
    result.unit = shownUnitName(better.name);
    result.prefixes->unit = &better;
    return result;
}

ShownUnit ShownUnits::of(UnitKind kind, double size) const {
    const auto own = chosen.find(kind);
    if (own != chosen.end()) return shownUnit(*own->second);
    const Unit& unit = handyUnit(kind, size, system);
    ShownUnit shown = shownUnit(unit);
    shown.prefixes = {kind, system, &unit};
    return shown;
}

ShownUnits shownUnits(UnitSystem units, const Scales& scales, const ChosenUnits& chosen) {
    ShownUnits shown;
    shown.system = units;
    shown.chosen = chosen;
    // A blow lasts tens of t0: the step to the next unit is taken a decade early.
    const auto unit = [&](UnitKind kind, double scale, const char* symbol, double typical = 1) {
        if (units == UnitSystem::dimensionless) return ShownUnit{1, QString::fromUtf8(symbol), true};
        ShownUnit physical = shown.of(kind, scale * typical);
        physical.factor *= scale;
        return physical;
    };
    shown.time = unit(UnitKind::time, scales.time, "t₀", 10);
    shown.force = unit(UnitKind::force, scales.force, "F₀");
    shown.impulse = unit(UnitKind::impulse, scales.impulse, "I₀");
    shown.penetration = unit(UnitKind::penetration, scales.penetration, "d₀");
    shown.stiffness = unit(UnitKind::stiffness, scales.stiffness, "k₀");
    shown.energy = unit(UnitKind::energy, scales.energy, "W₀");
    shown.stress = unit(UnitKind::stress, scales.stress, "F₀");
    shown.length = unit(UnitKind::length, scales.length, "L");
    shown.velocity = unit(UnitKind::speed, scales.velocity, "v₀");
    return shown;
}

}  // namespace drillwave
