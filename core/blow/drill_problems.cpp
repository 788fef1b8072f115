// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/drill_problems.h"

#include "core/model/blow_traits.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/text/handy_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

/// Waves that take longer to the bit than an interval are not followed.
constexpr double leastRoundTrips = 0.5;

/// No interval is off its mean by more deviations.
constexpr double widestScatter = 3;

}  // namespace

DrillLength scanLengthOf(const Scenario& scenario) {
    const Drill& drill = scenario.drill;
    DrillLength length;
    if (drill.blows) length = {static_cast<long>(*drill.blows), static_cast<long>(*drill.blows) / 5};
    if (drill.settle) length.settle = static_cast<long>(*drill.settle);
    return length;
}

std::vector<std::string> drillProblems(const Scenario& scenario, const DrillLength& length) {
    if (!hasUnits(scenario))
        return {"drillwave: a dimensionless scenario has no drill; give the rod and the drill in units"};
    const Drill& drill = scenario.drill;
    std::vector<std::string> problems;
    if (!drill.blowFrequency) problems.emplace_back("drill.blow_frequency: is missing: many blows need it");
    if (!drill.thrust) problems.emplace_back("drill.thrust: is missing: many blows need it");
    if (scenario.pulse.shape == PulseShape::rigidBody)
        problems.emplace_back("pulse.shape: the reference case rigid_body is one impact and has no blows");
    if (drill.machineMass.value_or(0) == 0) {
        if (drill.damperDamping.value_or(0) > 0)
            problems.emplace_back("drill.damper_damping: needs drill.machine_mass, which the damper carries");
        if (drill.damperStiffness.value_or(0) > 0)
            problems.emplace_back(
                "drill.damper_stiffness: needs drill.machine_mass, which the damper carries");
    }
    if (length.settle >= length.blows)
        problems.push_back("drill.settle: " + std::to_string(length.settle) +
                           " must be less than the blows, which are " + std::to_string(length.blows));
    if (!drill.blowFrequency || !problems.empty()) return problems;
    const double interval = 1 / *drill.blowFrequency;
    const double least = interval * (1 - widestScatter * drill.intervalScatter.value_or(0));
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

std::string drillProblem(const Scenario& scenario) {
    std::string line;
    for (const std::string& problem : drillProblems(scenario, scanLengthOf(scenario)))
        line += (line.empty() ? "" : "; ") + problem;
    return line;
}

}  // namespace drillwave
