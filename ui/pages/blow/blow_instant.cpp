// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_instant.h"

#include "core/wave/field/wave_field.h"

namespace drillwave {

BlowInstant blowInstant(const SolvedBlow& blow, double section, double time) {
    const Impact& impact = blow.impact;
    const double s = time - impact.frontArrival;
    const double given = blow.solved.hammer.isRigidBody() ? 1 : blow.solved.hammer.impulseUntil(time);
    const double taken = impactImpulse(impact, s);
    return {.normalForce = positiveWave(impact, section, time) + negativeWave(impact, section, time),
            .impactForce = impactForce(impact, s),
            .impulse = taken,
            .momentum = given - taken};
}

}  // namespace drillwave
