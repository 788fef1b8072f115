// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/output_unit.h"

#include <cmath>

#include "core/model/blow_traits.h"

namespace drillwave {

ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size) {
    switch (output.measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
        case Measure::energy:
            return {};
        case Measure::time:
            return units.time;
        case Measure::impulse:
            return units.impulse;
        case Measure::force:
            return units.force;
        case Measure::penetration:
            return units.penetration;
        case Measure::stress:
            return units.stress;
        case Measure::velocity:
            return units.velocity;
        case Measure::newton:
            return units.of(UnitKind::force, size);
        case Measure::watt:
            return units.of(UnitKind::power, size);
        case Measure::speed:
            return units.of(UnitKind::rate, size);
    }
    return {};
}

ShownUnit columnUnit(const OutputColumn& column, const ShownUnits& units, double size) {
    return column.quantity() == Quantity::energy ? units.energy : outputUnit(*column.output, units, size);
}

bool haveSameUnit(const Output& output, const SolvedBlow& one, const SolvedBlow& other, UnitSystem units) {
    if (followsFromGroups(one.scenario) == followsFromGroups(other.scenario)) return true;
    return units != UnitSystem::dimensionless || output.measure == Measure::number || output.isOnlySi();
}

std::optional<double> comparableNumber(const Output& output, const SolvedBlow& blow, UnitSystem units) {
    if (!blow.fault.isEmpty()) return std::nullopt;
    const std::optional<double> value = output.value({blow.summary, blow.scenario, blow.thrustMargin()});
    if (!value || !std::isfinite(*value)) return std::nullopt;
    if (output.measure == Measure::share || output.measure == Measure::energy) return 100 * *value;
    const bool isPlain = output.isOnlySi() || output.measure == Measure::number;
    if (isPlain || units == UnitSystem::dimensionless) return value;
    if (blow.scenario.form == ScenarioForm::dimensionless) return std::nullopt;
    return *value * (output.measure == Measure::work ? blow.scales.energy : output.scale(blow.scales));
}

}  // namespace drillwave
