// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/optional_parameter.h"

namespace drillwave {

std::optional<double>* optionalValue(Scenario& scenario, std::string_view key) {
    if (key == "rod.area") return &scenario.rod.area;
    if (key == "rod.yield_strength") return &scenario.rod.yieldStrength;
    if (key == "rod.fatigue_strength") return &scenario.rod.fatigueStrength;
    if (key == "pulse.youngs_modulus") return &scenario.pulse.piston.youngsModulus;
    if (key == "pulse.density") return &scenario.pulse.piston.density;
    if (key == "drill.blow_frequency") return &scenario.drill.blowFrequency;
    if (key == "drill.thrust") return &scenario.drill.thrust;
    return nullptr;
}

}  // namespace drillwave
