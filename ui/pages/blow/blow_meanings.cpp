// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_meanings.h"

#include "core/blow/blow_waves.h"
#include "core/wave/field/wave_curves.h"

namespace drillwave {
namespace {

// Functions of t/t0 become functions of the time shown, their values those shown.
std::function<double(double)> shownValue(const ShownUnits& units, const ShownUnit& unit,
                                         std::function<double(double)> value) {
    return [time = units.time.factor, size = unit.factor, value = std::move(value)](double x) {
        return size * value(x / time);
    };
}

const QString timeSymbol = QStringLiteral("t");

CurveMeaning momentumLike(const ShownUnits& units, std::function<double(double)> value) {
    CurveMeaning meaning;
    meaning.xName = timeSymbol;
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
    meaning.xName = timeSymbol;
    meaning.xUnit = units.time.unit;
    meaning.yUnit = units.force.unit;
    meaning.integralUnit = units.impulse.unit;
    meaning.integralFactor = units.impulse.factor / (units.force.factor * units.time.factor);
    if (!value) return meaning;
    meaning.value = shownValue(units, units.force, std::move(value));
    if (!impulse) return meaning;
    meaning.integral = [time = units.time.factor, force = units.force.factor, impulse = std::move(impulse)](
                           double a, double b) {
        return force * time * (impulse(b / time) - impulse(a / time));
    };
    return meaning;
}

// Returns the meaning of one of the waves at the section, over the round trip from its arrival, as drawn.
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

BlowMeanings blowMeanings(const SolvedBlowPtr& blow) {
    const ShownUnits& units = blow->units;
    const double section = blow->page<BlowCurves>()->section;
    // Values are read on demand; the blow lives as long as the function.
    const auto reading = [blow, section](double RodState::*value) {
        return [=](double t) { return BlowWaves(*blow).state(section, t).*value; };
    };
    const auto force = [&](double RodState::*value, std::function<double(double)> impulse = {}) {
        return forceLike(units, reading(value), std::move(impulse));
    };
    BlowMeanings meanings;
    meanings.waves.fill(forceMeaning(units));
    // Read from their points: each is many waves.
    meanings.laterWaves.fill(forceMeaning(units));
    meanings.closedForm = forceMeaning(units);
    meanings.faceForce = forceMeaning(units);
    if (blow->impact.waves) {
        meanings.waves[0] = force(&RodState::positiveWave);
        meanings.waves[1] = force(&RodState::negativeWave);
        meanings.sectionForce = force(&RodState::normalForce);
        meanings.force = force(&RodState::impactForce);
        meanings.faceForce = force(&RodState::faceForce);
    } else {
        for (int i = 0; i < BlowCurves::waveCount; ++i)
            meanings.waves[static_cast<std::size_t>(i)] = waveMeaning(blow, i);
        meanings.sectionForce = force(&RodState::normalForce, [blow, section](double t) {
            return sectionImpulse(blow->impact, section, t);
        });
        meanings.force = force(&RodState::impactForce, reading(&RodState::impulse));
    }
    meanings.impulse = momentumLike(units, reading(&RodState::impulse));
    meanings.momentum = momentumLike(units, reading(&RodState::momentum));
    return meanings;
}

}  // namespace drillwave
