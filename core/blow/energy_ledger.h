// SPDX-License-Identifier: GPL-3.0-or-later
// Where the work of the hammer went.
#pragma once

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Shares of the hammer work W, or of the energy E0 of a hammer that is followed; of a uniform rod the first
/// three together are 1 + residual.
struct EnergyLedger {
    double rockWork = 0;            ///< left in the rock [W]
    double reboundEnergy = 0;       ///< of the rod moving back as a whole [W]
    double residualWaveEnergy = 0;  ///< of the waves left in the rod [W]
    double residual = 0;            ///< error of the balance [W]
    bool operator==(const EnergyLedger&) const = default;
};

/// Of an impact solved with Detail::ledger or more.
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem);

}  // namespace drillwave
