// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/thrust.h"

#include <algorithm>

#include "core/model/blow_traits.h"
#include "core/model/scales.h"

namespace drillwave {

std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred) {
    if (!thrustProblem(scenario).empty()) return std::nullopt;
    return *scenario.drill.blowFrequency * pulseImpulse(scenario) * transferred * (1 + std::max(cor, 0.0));
}

std::string thrustProblem(const Scenario& scenario) {
    return frequencyProblem(scenario, "the thrust");
}

std::string thrustMarginProblem(const Scenario& scenario) {
    if (!gapHasPeriod(scenario))
        return "the margin of the thrust is known of uniform rods alone (`drillwave: 1`)";
    if (std::string problem = thrustProblem(scenario); !problem.empty()) return problem;
    if (!scenario.drill.thrust)
        return "the margin of the thrust needs drill.thrust; give it in the scenario or with --set";
    return {};
}

std::string frequencyProblem(const Scenario& scenario, std::string_view what) {
    if (!hasUnits(scenario))
        return std::string(what) +
               " needs a scenario in physical units; this one is given by its dimensionless groups";
    if (!scenario.drill.blowFrequency)
        return std::string(what) + " needs drill.blow_frequency; give it in the scenario or with --set";
    return {};
}

}  // namespace drillwave
