// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a blow at one instant.
#pragma once

#include "ui/job/solved_blow.h"

namespace drillwave {

/// Dimensionless, exact at any time, also behind the end of the recording.
struct BlowInstant {
    double normalForce = 0;  ///< N at the section, tension positive [F0]
    double impactForce = 0;  ///< F [F0]
    double impulse = 0;      ///< of the impact force so far [I0]
    double momentum = 0;     ///< of the rod, positive towards the rock [I0]
};

/// At the section ξ = x/L and the global time t/t0 of a solved blow.
BlowInstant blowInstant(const SolvedBlow& blow, double section, double time);

}  // namespace drillwave
