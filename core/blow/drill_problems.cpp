// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/drill_problems.h"

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Waves that take longer to the bit than an interval are not followed.
constexpr double leastRoundTrips = 0.5;

/// An interval of more t0 takes more cells than are followed.
constexpr double longestInterval = 1e7;

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

std::vector<Message> drillProblems(const Scenario& scenario, const DrillLength& length) {
    if (!hasUnits(scenario))
        return {about(
            std::string("drillwave"),
            translatable("a dimensionless scenario has no drill; give the rod and the drill in units"))};
    const Drill& drill = scenario.drill;
    std::vector<Message> problems;
    const auto add = [&](const char* key, Message problem) {
        problems.push_back(about(std::string(key), std::move(problem)));
    };
    if (!drill.blowFrequency) add("drill.blow_frequency", translatable("is missing: many blows require it"));
    if (!drill.thrust) add("drill.thrust", translatable("is missing: many blows require it"));
    if (scenario.pulse.shape == PulseShape::rigidBody)
        add("pulse.shape", translatable("the reference case rigid_body is one impact and has no blows"));
    if (drill.machineMass.value_or(0) == 0) {
        if (drill.damperDamping.value_or(0) > 0)
            add("drill.damper_damping", translatable("needs drill.machine_mass, which the damper carries"));
        if (drill.damperStiffness.value_or(0) > 0)
            add("drill.damper_stiffness", translatable("needs drill.machine_mass, which the damper carries"));
    }
    if (length.settle >= length.blows)
        add("drill.settle", {translatable("%1 must be less than the blows, which are %2"),
                             {std::to_string(length.settle), std::to_string(length.blows)}});
    if (!drill.blowFrequency || !problems.empty()) return problems;
    const double interval = 1 / *drill.blowFrequency;
    const double least = interval * (1 - widestScatter * drill.intervalScatter.value_or(0));
    const double pulse =
        isForced(scenario) ? pulseForceOf(scenario).end * pulseDuration(scenario) : pulseDuration(scenario);
    if (!(pulse < least))
        add("drill.blow_frequency", {translatable("a blow lasts %1 s, not less than the interval of the "
                                                  "blows; lower the frequency or shorten the blow"),
                                     {formatNumber(pulse)}});
    if (const double t0 = scalesOf(scenario).time; interval / t0 > longestInterval)
        add("drill.blow_frequency",
            {translatable(
                 "the interval of the blows is %1 times t0 = %2 s, at most %3 are followed; raise the "
                 "frequency or make the blow longer"),
             {rounded(interval / t0, 3), rounded(t0, 3), rounded(longestInterval, 3)}});
    const double roundTrips = interval / (2 * chainProperties(scenario).transitTime);
    if (roundTrips < leastRoundTrips)
        add("drill.blow_frequency",
            {translatable("waves take longer from hammer to bit than from blow to blow (%1 round trips); "
                          "lower the frequency or make the string shorter"),
             {formatNumber(roundTrips)}});
    return problems;
}

Message drillProblem(const Scenario& scenario) {
    return inOneLine(drillProblems(scenario, scanLengthOf(scenario)));
}

}  // namespace drillwave
