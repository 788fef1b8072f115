// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/thrust.h"

#include <algorithm>

#include "core/model/blow_traits.h"
#include "core/model/scales.h"

namespace drillwave {

std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred) {
    if (!thrustProblem(scenario).isEmpty()) return std::nullopt;
    return *scenario.drill.blowFrequency * pulseImpulse(scenario) * transferred * (1 + std::max(cor, 0.0));
}

Message thrustProblem(const Scenario& scenario) {
    return frequencyProblem(scenario, translatable("the thrust"));
}

Message thrustMarginProblem(const Scenario& scenario) {
    if (!gapHasPeriod(scenario))
        return translatable("the margin of the thrust is known of uniform rods alone (`drillwave: 1`)");
    if (const Message problem = thrustProblem(scenario); !problem.isEmpty()) return problem;
    if (!scenario.drill.thrust)
        return translatable(
            "the margin of the thrust needs drill.thrust; give it in the scenario or with --set");
    return {};
}

Message frequencyProblem(const Scenario& scenario, const char* what) {
    if (!hasUnits(scenario))
        return {translatable("%1 needs a scenario in physical units; this one is given by its "
                             "dimensionless groups"),
                {what}};
    if (!scenario.drill.blowFrequency)
        return {translatable("%1 needs drill.blow_frequency; give it in the scenario or with --set"), {what}};
    return {};
}

}  // namespace drillwave
