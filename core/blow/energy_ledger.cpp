// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/energy_ledger.h"

namespace drillwave {

// Energies of `impact` are in I0²/(Z t0).
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem) {
    const double work = impact.hammerWork;
    // m v²/2 with p = e I0 and m = ZT is e²/(2τ) in I0²/(Z t0).
    const double rebound = impact.cor * impact.cor / (2 * problem.transitTime());
    return {.rockWork = impact.rockWork / work,
            .reboundEnergy = rebound / work,
            .residualWaveEnergy = (impact.finalEnergy - rebound) / work,
            .residual = (impact.rockWork + impact.finalEnergy - work) / work};
}

}  // namespace drillwave
