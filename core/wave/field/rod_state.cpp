// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_state.h"

#include <cassert>

#include "core/wave/field/wave_field.h"

namespace drillwave {

double rodMomentum(const PulseForce& pulse, double t, double taken) {
    const double given = pulse.isRigidBody() ? 1 : pulse.impulseUntil(t);
    return given - taken;
}

double rodMomentum(const Impact& impact, const PulseForce& pulse, double t) {
    return rodMomentum(pulse, t, WaveField(impact).impactImpulse(t));
}

RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t) {
    assert(impact.hasHistories());
    const WaveField field(impact);
    const double taken = field.impactImpulse(t);
    const double positive = field.positiveWave(xi, t), negative = field.negativeWave(xi, t);
    return {.normalForce = positive + negative,
            .impactForce = field.impactForce(t),
            .impulse = taken,
            .momentum = rodMomentum(pulse, t, taken),
            .positiveWave = positive,
            .negativeWave = negative};
}

}  // namespace drillwave
