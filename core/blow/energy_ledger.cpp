// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/energy_ledger.h"

namespace drillwave {

// Energies of `impact` are in I0²/(Z t0).
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem) {
    const double work = impact.hammerWork;
    // p²/(2m); e of a string with losses is from the impulse on the rock, which is not its own momentum
    const double momentum = losesWaves(problem) ? impact.finalMomentum : impact.cor * impact.faceImpulse;
    const double rebound = momentum * momentum / (2 * problem.mass());
    return {.rockWork = impact.rockWork / work,
            .reboundEnergy = rebound / work,
            .residualWaveEnergy = (impact.finalEnergy - rebound) / work,
            .residual = (impact.rockWork + impact.energyLeft() - work) / work};
}

}  // namespace drillwave
