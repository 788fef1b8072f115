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
    return rodMomentum(pulse, t, impactImpulse(impact, t - impact.frontArrival));
}

RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t) {
    assert(impact.hasHistories());
    const double s = t - impact.frontArrival;
    const double taken = impactImpulse(impact, s);
    return {.normalForce = positiveWave(impact, xi, t) + negativeWave(impact, xi, t),
            .impactForce = impactForce(impact, s),
            .impulse = taken,
            .momentum = rodMomentum(pulse, t, taken)};
}

}  // namespace drillwave
