// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_meanings.h"

#include "core/wave/field/rod_state.h"
#include "core/wave/field/section_force.h"
#include "core/wave/field/wave_curves.h"
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

const QString time = QStringLiteral("t");

CurveMeaning momentumLike(const ShownUnits& units, std::function<double(double)> value) {
    CurveMeaning meaning;
    meaning.xName = time;
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
    meaning.xName = time;
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
    const double section = blow->page<BlowCurves>()->section;
    return forceLike(
        blow->units,
        [blow, section, number](double t) { return sectionWave(blow->impact, section, number, t); },
        [blow, section, number](double t) { return sectionWaveImpulse(blow->impact, section, number, t); });
}

}  // namespace

CurveMeaning forceMeaning(const ShownUnits& units) {
    return forceLike(units, {}, {});
}

namespace {

// The state of a string at a place, read when asked; the blow lives as long as the function.
BlowMeanings stringMeanings(const SolvedBlowPtr& blow) {
    const ShownUnits& units = blow->units;
    const StringPlace place = *blow->page<BlowCurves>()->place;
    const auto reading = [blow, place](double StringInstant::*value) {
        return [blow, place, value](double t) {
            return StringHistory(blow->impact, blow->problem, place).at(t).*value;
        };
    };
    BlowMeanings meanings;
    meanings.waves.fill(forceMeaning(units));
    meanings.laterWaves.fill(forceMeaning(units));
    meanings.closedForm = forceMeaning(units);
    meanings.faceForce = forceMeaning(units);
    meanings.sectionForce = forceMeaning(units);
    meanings.force = forceMeaning(units);
    const auto value = [&](double StringInstant::*which) {
        return shownValue(units, units.force, reading(which));
    };
    meanings.waves[0].value = value(&StringInstant::positiveWave);
    meanings.waves[1].value = value(&StringInstant::negativeWave);
    meanings.sectionForce.value = value(&StringInstant::normalForce);
    meanings.force.value = value(&StringInstant::impactForce);
    meanings.faceForce.value = value(&StringInstant::faceForce);
    meanings.impulse = momentumLike(units, reading(&StringInstant::impulse));
    meanings.momentum = momentumLike(units, reading(&StringInstant::momentum));
    return meanings;
}

}  // namespace

BlowMeanings blowMeanings(const SolvedBlowPtr& blow) {
    if (blow->isOfString()) return stringMeanings(blow);
    const ShownUnits& units = blow->units;
    BlowMeanings meanings;
    for (int i = 0; i < BlowCurves::waveCount; ++i)
        meanings.waves[static_cast<std::size_t>(i)] = waveMeaning(blow, i);
    // Read from their points: each is many waves.
    meanings.laterWaves.fill(forceLike(units, {}, {}));
    const double section = blow->page<BlowCurves>()->section;
    meanings.sectionForce = forceLike(
        units, [blow, section](double t) { return WaveField(blow->impact).force(section, t); },
        [blow, section](double t) { return sectionImpulse(blow->impact, section, t); });
    meanings.force = forceLike(
        units, [blow](double t) { return WaveField(blow->impact).impactForce(t); },
        [blow](double t) { return WaveField(blow->impact).impactImpulse(t); });
    meanings.closedForm = forceMeaning(units);
    meanings.faceForce = forceMeaning(units);
    meanings.impulse =
        momentumLike(units, [blow](double t) { return WaveField(blow->impact).impactImpulse(t); });
    meanings.momentum =
        momentumLike(units, [blow](double t) { return rodMomentum(blow->impact, blow->problem.force(), t); });
    return meanings;
}

}  // namespace drillwave
