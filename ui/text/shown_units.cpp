// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_units.h"

#include <cmath>
#include <initializer_list>

namespace drillwave {
namespace {

struct Prefixed {
    const char* unit;
    double factor;  // SI value of the unit
};

// The largest unit in which the characteristic size is at least one; the smallest when there is none.
ShownUnit siUnit(double size, std::initializer_list<Prefixed> descending) {
    const Prefixed* chosen = descending.begin();
    for (const Prefixed& unit : descending) {
        chosen = &unit;
        if (size >= unit.factor) break;
    }
    return {size / chosen->factor, QString::fromUtf8(chosen->unit), false};
}

}  // namespace

UnitSystem naturalUnits(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional ? UnitSystem::si : UnitSystem::dimensionless;
}

QString ShownUnit::axisLabel(const QString& words) const {
    return dimensionless ? QStringLiteral("%1 / %2").arg(words, unit)
                         : QStringLiteral("%1 [%2]").arg(words, unit);
}

ShownUnits shownUnits(UnitSystem units, const Scales& scales) {
    if (units == UnitSystem::dimensionless)
        return {{1, QStringLiteral("t₀"), true}, {1, QStringLiteral("F₀"), true},
                {1, QStringLiteral("I₀"), true}, {1, QStringLiteral("d₀"), true},
                {1, QStringLiteral("k₀"), true}, {1, QStringLiteral("W₀"), true}};
    // A blow lasts tens of t0: the step to the next unit is taken a decade early.
    ShownUnit time = siUnit(scales.time * 10, {{"s", 1}, {"ms", 1e-3}, {"µs", 1e-6}, {"ns", 1e-9}});
    time.factor /= 10;
    return {time,
            siUnit(scales.force, {{"GN", 1e9}, {"MN", 1e6}, {"kN", 1e3}, {"N", 1}}),
            siUnit(scales.impulse, {{"MN s", 1e6}, {"kN s", 1e3}, {"N s", 1}}),
            siUnit(scales.penetration, {{"m", 1}, {"mm", 1e-3}, {"µm", 1e-6}}),
            siUnit(scales.stiffness, {{"GN/m", 1e9}, {"MN/m", 1e6}, {"kN/m", 1e3}, {"N/m", 1}}),
            siUnit(scales.energy, {{"MJ", 1e6}, {"kJ", 1e3}, {"J", 1}, {"mJ", 1e-3}})};
}

}  // namespace drillwave
