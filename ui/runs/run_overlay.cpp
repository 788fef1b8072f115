// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_overlay.h"

namespace drillwave {

std::optional<ShownUnits> unitsOf(const SolvedBlow& run, const ShownUnits& units, const Scales& scales) {
    if (units.system == UnitSystem::dimensionless) return units;
    if (run.scenario.form == ScenarioForm::dimensionless) return std::nullopt;
    ShownUnits own = units;
    const auto follow = [&](ShownUnit ShownUnits::*unit, double Scales::*scale) {
        (own.*unit).factor *= run.scales.*scale / scales.*scale;
    };
    follow(&ShownUnits::time, &Scales::time);
    follow(&ShownUnits::force, &Scales::force);
    follow(&ShownUnits::impulse, &Scales::impulse);
    follow(&ShownUnits::penetration, &Scales::penetration);
    follow(&ShownUnits::stiffness, &Scales::stiffness);
    follow(&ShownUnits::energy, &Scales::energy);
    follow(&ShownUnits::stress, &Scales::stress);
    follow(&ShownUnits::length, &Scales::length);
    return own;
}

bool areSameUnits(const ShownUnits& a, const ShownUnits& b) {
    const auto isSame = [&](ShownUnit ShownUnits::*unit) { return (a.*unit).unit == (b.*unit).unit; };
    return a.system == b.system && isSame(&ShownUnits::time) && isSame(&ShownUnits::force) &&
           isSame(&ShownUnits::impulse) && isSame(&ShownUnits::penetration) &&
           isSame(&ShownUnits::stiffness) && isSame(&ShownUnits::energy) && isSame(&ShownUnits::stress) &&
           isSame(&ShownUnits::length);
}

}  // namespace drillwave
