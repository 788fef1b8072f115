// SPDX-License-Identifier: GPL-3.0-or-later
// Scaling of blows to equal energy, for comparing machines at equal power.
#pragma once

#include <string>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the energy of a blow [J]. A prescribed hammer force gives the energy of its incident wave, ∫Fa²
/// dt/Z. An elastic hammer gives its kinetic energy m v0²/2. A rod that itself arrives with velocity gives
/// I0²/2m. Requires a valid scenario with units.
double blowEnergy(const Scenario& scenario);

/// Returns the parameter that scales the blow energy: the impulse or the hammer velocity. nullptr if the
/// hammer force is a table of points.
KeptParameter energyParameter(const Scenario& scenario);

/// Returns why the blow energy of a scenario cannot be kept constant and what to do; empty if it can.
Message keepEnergyProblem(const Scenario& scenario);

/// Sets the blow energy of a scenario to `energy` [J]: multiplies the impulse or hammer velocity by
/// √(energy/blowEnergy()). Requires that keepEnergyProblem() is empty.
void keepEnergy(Scenario& scenario, double energy);

}  // namespace drillwave
