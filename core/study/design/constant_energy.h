// SPDX-License-Identifier: GPL-3.0-or-later
// Blows of one energy: machines compared at equal power.
#pragma once

#include <string>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the energy of a blow [J]: of a prescribed force that of its incident wave, ∫Fa² dt/Z, in the
/// reference case I0²/2m, of an elastic hammer m v0²/2. Requires a valid scenario with units.
double blowEnergy(const Scenario& scenario);

/// Returns the parameter that scales the energy: impulse or hammer velocity; none for a table of points.
KeptParameter energyParameter(const Scenario& scenario);

/// Returns why the energy of such a scenario cannot be kept and what to do; empty if it can be.
Message keepEnergyProblem(const Scenario& scenario);

/// Gives the blow that energy: impulse or velocity times √(energy/blowEnergy()). Requires that there is no
/// keepEnergyProblem().
void keepEnergy(Scenario& scenario, double energy);

}  // namespace drillwave
