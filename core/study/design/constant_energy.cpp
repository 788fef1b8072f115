// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/constant_energy.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/model/parameter.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"

namespace drillwave {

namespace {

double pistonEnergy(const Scenario& scenario) {
    const Piston& piston = scenario.pulse.piston;
    const double area = std::numbers::pi / 4 * piston.diameter * piston.diameter;
    const double mass = piston.density.value_or(scenario.rod.density) * area * piston.length;
    return mass * piston.velocity * piston.velocity / 2;
}

}  // namespace

double blowEnergy(const Scenario& scenario) {
    const Scales scales = scalesOf(scenario);
    if (!isForced(scenario)) return scales.energy;
    if (scenario.pulse.shape == PulseShape::piston && !isString(scenario)) return pistonEnergy(scenario);
    if (scenario.pulse.shape == PulseShape::rigidBody) return scales.impulse * scales.velocity / 2;
    double squares = 0;
    for (const PulseSegment& segment : pulseForceOf(scenario).segments)
        squares += segment.energyOf(0, segment.length);
    // F0² t0/Z, d0 = 2 I0/Z
    return squares * scales.force * scales.penetration / 2;
}

KeptParameter energyParameter(const Scenario& scenario) {
    for (const char* key : {"hammer.velocity", "pulse.velocity", "pulse.impulse"})
        if (KeptParameter parameter = findParameter(key); parameter->applies(scenario)) return parameter;
    return nullptr;
}

Message keepEnergyProblem(const Scenario& scenario) {
    if (!hasUnits(scenario))
        return translatable("a dimensionless scenario has no energy to keep; leave it out");
    if (!energyParameter(scenario))
        return translatable("a blow of given points has neither impulse nor velocity to scale; leave it out");
    return {};
}

void keepEnergy(Scenario& scenario, double energy) {
    const KeptParameter parameter = energyParameter(scenario);
    parameter->assign(scenario, *parameter->value(scenario) * std::sqrt(energy / blowEnergy(scenario)));
}

}  // namespace drillwave
