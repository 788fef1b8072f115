// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_case.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/blow/feed_force.h"

namespace drillwave {

namespace {

bool hasDamper(const Drill& drill) {
    return drill.damperDamping.value_or(0) > 0 || drill.damperStiffness.value_or(0) > 0;
}

/// The share that waves lose in one round trip, from the losses of joints and rods and from `wave_loss`.
std::vector<double> waveLosses(const Scenario& scenario, const Problem& blow) {
    const std::size_t hammer = blow.hammerSections(), count = blow.sections.size();
    std::vector<double> kept(count, 1);
    const double ofAll = 1 - scenario.drill.waveLoss.value_or(0);
    for (std::size_t j = hammer; j < count; ++j) {
        const UniformSection& section = blow.sections[j];
        kept[j] *= std::pow(ofAll, section.transitTime / blow.transitTime()) * std::exp(-2 * section.decay);
        if (j + 1 == count || section.loss == 0) continue;
        // of the longer one, of two equal ones of that behind
        const bool own = section.transitTime >= blow.sections[j + 1].transitTime;
        kept[own ? j : j + 1] *= 1 - section.loss;
    }
    std::vector<double> losses;
    for (const double share : kept) losses.push_back(1 - share);
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
    return drillProblems(scenario, {settings.blows, settings.settle});
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
    for (UniformSection& section : blow.sections) section.loss = section.decay = 0;
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
