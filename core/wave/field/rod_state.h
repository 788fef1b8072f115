// SPDX-License-Identifier: GPL-3.0-or-later
// The state of rod or string during a blow at one instant.
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Momentum of the rod, p = ∫Fa dt − ∫F ds [I0] (T20), towards the rock positive, at the global time t/t0:
/// what the hammer has given it less `taken`, the impulse of the impact force so far. In the reference case
/// it is given before the first contact.
double rodMomentum(const PulseForce& pulse, double t, double taken);

/// The same, the impulse of the impact force being looked up. Needs an impact solved with Detail::histories.
double rodMomentum(const Impact& impact, const PulseForce& pulse, double t);

/// Dimensionless.
struct RodState {
    double normalForce = 0;   ///< N at the section, tension positive [F0] (T2)
    double impactForce = 0;   ///< F ≥ 0 [F0]
    double impulse = 0;       ///< ∫F so far [I0]
    double momentum = 0;      ///< p of the rod, towards the rock positive [I0]
    double positiveWave = 0;  ///< Np at the section, tension positive [F0]
    double negativeWave = 0;  ///< Nn likewise
    double faceForce = 0;     ///< of hammer and string ≥ 0 [F0]; not told of a rod
};

/// Exact at any time, also behind the end of the recording. At the section ξ = x/L and the global time t/t0.
/// Needs an impact solved with Detail::histories.
RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t);

}  // namespace drillwave
