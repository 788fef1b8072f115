// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_meanings.h"

#include <algorithm>
#include <limits>

#include "core/wave/field/rod_state.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {
namespace {

// Functions of t/t0 become functions of the time shown, their values those shown.
std::function<double(double)> shownValue(const ShownUnits& units, const ShownUnit& unit,
                                         std::function<double(double)> value) {
    return [time = units.time.factor, size = unit.factor, value = std::move(value)](double x) {
        return size * value(x / time);
    };
}

CurveMeaning momentumLike(const ShownUnits& units, std::function<double(double)> value) {
    CurveMeaning meaning;
    meaning.xUnit = units.time.unit;
    meaning.yUnit = units.impulse.unit;
    if (value) meaning.value = shownValue(units, units.impulse, std::move(value));
    // dI/dt is a force.
    meaning.slopeUnit = units.force.unit;
    meaning.slopeFactor = units.force.factor * units.time.factor / units.impulse.factor;
    return meaning;
}

// `impulse` is ∫ value from any fixed time on.
CurveMeaning forceLike(const ShownUnits& units, std::function<double(double)> value,
                       std::function<double(double)> impulse) {
    CurveMeaning meaning;
    meaning.xUnit = units.time.unit;
    meaning.yUnit = units.force.unit;
    meaning.integralUnit = units.impulse.unit;
    meaning.integralFactor = units.impulse.factor / (units.force.factor * units.time.factor);
    if (!value) return meaning;
    meaning.value = shownValue(units, units.force, std::move(value));
    meaning.integral = [time = units.time.factor, force = units.force.factor, impulse = std::move(impulse)](
                           double a, double b) {
        return force * time * (impulse(b / time) - impulse(a / time));
    };
    return meaning;
}

// One of the waves at the section: over the round trip from its arrival, as it is drawn.
CurveMeaning waveMeaning(const SolvedBlowPtr& blow, int number) {
    const double roundTrip = blow->impact.roundTrip;
    const bool forward = number % 2 == 0;
    const double section = blow->page<BlowCurves>()->section;
    const double begin = number / 2 * roundTrip;
    // From the global time to that at the front end: a wave to +x has still to get there.
    const double shift = -blow->impact.frontArrival + (forward ? 1 : -1) * (1 - section) * roundTrip / 2;
    const auto value = [blow, forward, section, begin, shift, roundTrip](double t) {
        const double s = t + shift;
        if (s < begin || s > begin + roundTrip) return std::numeric_limits<double>::quiet_NaN();
        return forward ? positiveWave(blow->impact, section, t) : negativeWave(blow->impact, section, t);
    };
    const auto impulse = [blow, forward, begin, shift, roundTrip](double t) {
        const double s = std::clamp(t + shift, begin, begin + roundTrip);
        const double incident = incidentImpulse(blow->impact, s);
        return forward ? -incident : incident - impactImpulse(blow->impact, s);
    };
    return forceLike(blow->units, value, impulse);
}

}  // namespace

BlowMeanings blowMeanings(const SolvedBlowPtr& blow) {
    const ShownUnits& units = blow->units;
    const double arrival = blow->impact.frontArrival;
    BlowMeanings meanings;
    for (int i = 0; i < BlowCurves::waveCount; ++i)
        meanings.waves[static_cast<std::size_t>(i)] = waveMeaning(blow, i);
    meanings.force = forceLike(
        units, [blow, arrival](double t) { return impactForce(blow->impact, t - arrival); },
        [blow, arrival](double t) { return impactImpulse(blow->impact, t - arrival); });
    meanings.closedForm = forceLike(units, {}, {});
    meanings.impulse =
        momentumLike(units, [blow, arrival](double t) { return impactImpulse(blow->impact, t - arrival); });
    meanings.momentum =
        momentumLike(units, [blow](double t) { return rodMomentum(blow->impact, blow->solved.hammer, t); });
    return meanings;
}

}  // namespace drillwave
