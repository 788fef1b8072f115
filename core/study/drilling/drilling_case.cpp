// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_case.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/blow/feed_estimate.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

bool hasDamper(const Drill& drill) {
    return drill.damperDamping.value_or(0) > 0 || drill.damperStiffness.value_or(0) > 0;
}

/// The share that waves lose in one round trip of each section by `wave_loss`, which is that of all of them.
std::vector<double> waveLosses(const Scenario& scenario, const Problem& blow) {
    const double kept = 1 - scenario.drill.waveLoss.value_or(0);
    std::vector<double> losses(blow.sections.size(), 0);
    for (std::size_t j = blow.hammerSections(); j < losses.size(); ++j)
        losses[j] = 1 - std::pow(kept, blow.sections[j].transitTime / blow.transitTime());
    return losses;
}

}  // namespace

DrillingSettings drillingSettingsOf(const Scenario& scenario, long usualBlows) {
    DrillingSettings settings;
    settings.blows = scenario.drill.blows ? static_cast<long>(*scenario.drill.blows) : usualBlows;
    settings.settle = scenario.drill.settle ? static_cast<long>(*scenario.drill.settle) : settings.blows / 5;
    return settings;
}

DrillingSettings scanSettingsOf(const Scenario& scenario) {
    const DrillLength length = scanLengthOf(scenario);
    return {.blows = length.blows, .settle = length.settle, .cells = scanCells};
}

std::vector<Message> drillingRefusals(const Scenario& scenario, const DrillingSettings& settings) {
    if (Message problem = invalidity(scenario); !problem.isEmpty()) return {std::move(problem)};
    std::vector<Message> problems = drillProblems(scenario, {settings.blows, settings.settle});
    const auto add = [&](const char* what, long value, long least, long most) {
        if (value < least || value > most)
            problems.emplace_back(translatable("%1 must be from %2 to %3, not %4"),
                                  std::vector<Message>{what, std::to_string(least), std::to_string(most),
                                                       std::to_string(value)});
    };
    add("drill.blows", settings.blows, 1, mostBlows);
    add("drill.settle", settings.settle, 0, mostBlows);
    add("cells", settings.cells, leastDrillingCells, mostDrillingCells);
    return problems;
}

DrillingUnits drillingUnitsOf(const Scenario& scenario) {
    const Scales scales = scalesOf(scenario);
    return {.time = scales.time, .force = scales.force, .velocity = scales.particleVelocity};
}

DrillingProblem drillingProblemOf(const Scenario& scenario, Problem blow) {
    const Drill& drill = scenario.drill;
    const DrillingUnits units = drillingUnitsOf(scenario);
    const double impedance = units.force / units.velocity;
    DrillingProblem problem;
    problem.waveLosses = waveLosses(scenario, blow);
    blow.endTime.reset();
    blow.nextBlow.reset();
    problem.blow = std::move(blow);
    problem.interval = 1 / (*drill.blowFrequency * units.time);
    problem.feedForce = feedForceOf(scenario)->effective() / units.force;
    if (drill.machineMass.value_or(0) > 0 && hasDamper(drill))
        problem.machine =
            MachineBody{.mass = *drill.machineMass / (impedance * units.time),
                        .damping = drill.damperDamping.value_or(0) / impedance,
                        .stiffness = drill.damperStiffness.value_or(0) * units.time / impedance};
    problem.isFresh = drill.indexing == RockIndexing::fresh;
    problem.intervalScatter = drill.intervalScatter.value_or(0);
    problem.seed = static_cast<std::uint32_t>(drill.seed.value_or(1));
    return problem;
}

}  // namespace drillwave
