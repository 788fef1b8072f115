// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_state.h"

#include <cassert>

#include "core/contact/contact_law.h"
#include "core/wave/field/bit_history.h"
#include "core/wave/field/wave_curves.h"
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
    return {.time = t,
            .impactForce = field.impactForce(t),
            .impulse = taken,
            .momentum = rodMomentum(pulse, t, taken),
            .normalForce = positive + negative,
            .positiveWave = positive,
            .negativeWave = negative};
}

std::vector<RodState> sampledStates(const Impact& impact, const Problem& problem) {
    const SampledHistory history = sampleHistory(impact);
    std::vector<RodState> states(history.time.size());
    ContactLaw<> rock(problem.law);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double time = history.time[i], force = history.force[i], incident = history.incident[i];
        rock.rememberAcross(force);
        // From the law of the rock while it pushes, because digits of the displacement of the bit would
        // cancel with those of a much longer way.
        const double penetration = force > 0 ? rock.penetration(force) * lawUnitOfPenetration
                                             : bitDisplacement(impact, time) - problem.firstGap();
        states[i] = {.time = time,
                     .impactForce = force,
                     .impulse = history.impulse[i],
                     .momentum = rodMomentum(problem.force(), time, history.impulse[i]),
                     .penetration = penetration,
                     .frontVelocity = incident - force / 2,
                     .positiveWave = incident == 0 ? 0 : -incident};
    }
    return states;
}

}  // namespace drillwave
