// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_numbers.h"

#include "core/text/message.h"

namespace drillwave {

namespace {

const BlowSpread& spreadAt(const DrillingResult& result, double DrillingBlow::*value) {
    return result.spread(quantityPlace(value));
}

}  // namespace

DrillNumbers drillNumbersOf(const DrillingResult& result) {
    DrillNumbers numbers;
    numbers.thrustNumber = result.groups.phi;
    numbers.roundTrips = result.groups.roundTrips;
    if (!result.blows.empty()) {
        numbers.momentumResidual = result.momentumResidual;
        numbers.energyResidual = result.energyResidual;
    }
    if (!result.statistics) return numbers;
    const DrillingStatistics& statistics = *result.statistics;
    const double gapUnit = result.units.length() / result.scales.penetration;
    const double forceUnit = result.units.force / result.scales.force;
    const BlowSpread& gap = spreadAt(result, &DrillingBlow::gap);
    numbers.gapMean = gap.mean * gapUnit;
    numbers.gapDeviation = gap.deviation * gapUnit;
    numbers.gap05 = gap.q05 * gapUnit;
    numbers.gap50 = gap.q50 * gapUnit;
    numbers.gap95 = gap.q95 * gapUnit;
    const BlowSpread& penetration = spreadAt(result, &DrillingBlow::penetration);
    numbers.penetration = penetration.mean * gapUnit;
    if (const std::optional<double> error = result.meanError(quantityPlace(&DrillingBlow::penetration)))
        numbers.penetrationError = *error * gapUnit;
    numbers.penetrationRate = penetration.mean * result.units.length() * result.frequencyUsed;
    numbers.rockImpulse =
        spreadAt(result, &DrillingBlow::rockImpulse).mean * result.units.impulse() / result.scales.impulse;
    numbers.peakForce = spreadAt(result, &DrillingBlow::peakForce).mean * forceUnit;
    numbers.damperForce = spreadAt(result, &DrillingBlow::damperPeak).largest * forceUnit;
    numbers.contactShare = statistics.contactShare;
    numbers.contacts = spreadAt(result, &DrillingBlow::contacts).mean;
    numbers.period = statistics.period;
    if (result.lyapunov) numbers.lyapunov = result.lyapunov->value;
    return numbers;
}

Message whyNoStatistics(const DrillingResult& result) {
    switch (result.outcome) {
        case DrillingOutcome::done:
            return {};
        case DrillingOutcome::pushedBack:
            return translatable("the machine is pushed back without limit");
        case DrillingOutcome::notSolved:
            return result.reason;
        case DrillingOutcome::stopped:
            return translatable("it was stopped");
    }
    return {};
}

}  // namespace drillwave
