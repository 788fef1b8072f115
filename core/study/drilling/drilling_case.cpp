// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_case.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/blow/feed_force.h"
#include "core/text/handy_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

/// Waves that take longer to the bit than an interval are not followed.
constexpr double leastRoundTrips = 0.5;

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

std::vector<std::string> drillingRefusals(const Scenario& scenario, const DrillingSettings& settings) {
    if (!hasUnits(scenario))
        return {"drillwave: a dimensionless scenario has no drill; give the rod and the drill in units"};
    const Drill& drill = scenario.drill;
    std::vector<std::string> problems;
    if (!drill.blowFrequency) problems.emplace_back("drill.blow_frequency: is missing: many blows need it");
    if (!drill.thrust) problems.emplace_back("drill.thrust: is missing: many blows need it");
    if (!isString(scenario) && scenario.pulse.shape == PulseShape::rigidBody)
        problems.emplace_back("pulse.shape: the reference case rigid_body is one impact and has no blows");
    if (drill.machineMass.value_or(0) == 0) {
        if (drill.damperDamping.value_or(0) > 0)
            problems.emplace_back("drill.damper_damping: needs drill.machine_mass, which the damper carries");
        if (drill.damperStiffness.value_or(0) > 0)
            problems.emplace_back(
                "drill.damper_stiffness: needs drill.machine_mass, which the damper carries");
    }
    if (settings.settle >= settings.blows)
        problems.push_back("drill.settle: " + std::to_string(settings.settle) +
                           " must be less than the blows, which are " + std::to_string(settings.blows));
    if (!drill.blowFrequency || !problems.empty()) return problems;
    const double interval = 1 / *drill.blowFrequency;
    const double least = interval * (1 - 3 * drill.intervalScatter.value_or(0));
    const double pulse =
        isForced(scenario) ? pulseForceOf(scenario).end * pulseDuration(scenario) : pulseDuration(scenario);
    if (!(pulse < least))
        problems.push_back("drill.blow_frequency: a blow lasts " + formatNumber(pulse) +
                           " s, which is no less than the interval of the blows; lower the frequency or make "
                           "the blow shorter");
    const double roundTrips = interval / (2 * chainProperties(scenario).transitTime);
    if (roundTrips < leastRoundTrips)
        problems.push_back(
            "drill.blow_frequency: waves take longer from hammer to bit than from blow to blow (" +
            formatNumber(roundTrips) + " round trips); lower the frequency or make the string shorter");
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
