// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/string_problem.h"

#include <cassert>

#include "core/model/scales.h"

namespace drillwave {

NetworkProblem networkProblemOf(const Scenario& scenario) {
    assert(isString(scenario));
    const DrillString& drill = scenario.drillString;
    const double impedance = propertiesOf(ruleSection(drill), drill.material).impedance;
    const double time = pulseDuration(scenario);
    const double velocity = drill.hammer.velocity;

    NetworkProblem problem;
    const auto add = [&](const Section& section) {
        const RodProperties properties = propertiesOf(section, drill.material);
        problem.sections.push_back({.impedance = properties.impedance / impedance,
                                    .transitTime = properties.transitTime / time,
                                    .decay = section.attenuation * section.length,
                                    .massAfter = section.massAfter / (impedance * time),
                                    .loss = section.loss});
    };
    for (const Section* section : allSections(drill)) add(*section);
    problem.hammerSections = drill.hammer.sections.size();
    const double slope = time / impedance;
    if (drill.hammer.faceStiffness) problem.face.stiffness = *drill.hammer.faceStiffness * slope;
    problem.face.restrike = drill.hammer.restrike;
    problem.law = {scenario.bitRock.stiffness * slope, scenario.bitRock.gamma};
    problem.gap = scenario.bitRock.gap / (velocity * time);
    if (drill.endTime) problem.endTime = *drill.endTime / time;
    if (scenario.drill.blowFrequency) problem.nextBlow = 1 / (*scenario.drill.blowFrequency * time);
    return problem;
}

}  // namespace drillwave
