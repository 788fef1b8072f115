// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/thrust.h"

#include "core/model/scales.h"

namespace drillwave {

std::optional<double> thrustNeeded(const Scenario& scenario, double cor) {
    if (!thrustProblem(scenario).empty()) return std::nullopt;
    return *scenario.drill.blowFrequency * pulseImpulse(scenario) * (1 + cor);
}

std::string thrustProblem(const Scenario& scenario) {
    if (scenario.form != ScenarioForm::dimensional)
        return "the thrust needs a scenario in physical units; this one is given by its dimensionless groups";
    if (!scenario.drill.blowFrequency)
        return "the thrust needs drill.blow_frequency; give it in the scenario or with --set";
    return {};
}

}  // namespace drillwave
