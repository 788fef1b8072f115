// SPDX-License-Identifier: GPL-3.0-or-later
// The state of rod or string during a blow at one instant.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Returns the momentum of the rod, p = ∫Fa dt − ∫F ds [I0] (T20), towards the rock positive, at the global
/// time t/t0: the impulse of the hammer less `taken`, the impulse of the impact force so far. In the
/// reference case the hammer gives it before the first contact.
double rodMomentum(const PulseForce& pulse, double t, double taken);

/// Returns the same, looking up the impulse of F. Requires an impact solved with Detail::histories.
double rodMomentum(const Impact& impact, const PulseForce& pulse, double t);

/// Normal forces are positive in tension, everything else towards the rock; fields that a uniform rod does
/// not have are 0. Times in t0, forces in F0; of two units, the first one is that of a rod, the second that
/// of a string.
struct RodState {
    double time = 0;
    double impactForce = 0;    ///< F ≥ 0 of bit and rock
    double impulse = 0;        ///< ∫F so far [I0; p0 of a followed hammer]
    double momentum = 0;       ///< given impulse less that [I0; p0]: p if nothing is lost (T20)
    double penetration = 0;    ///< of the bit below the first surface of the rock [d0; v0 t0]
    double frontVelocity = 0;  ///< of the bit [d0/t0; v0]
    double faceForce = 0;      ///< of hammer and string ≥ 0; 0 for a rod
    double normalForce = 0;    ///< N at the section (T2)
    double positiveWave = 0;   ///< Np there, which runs towards the bit
    double negativeWave = 0;   ///< Nn there, which runs back
    double velocity = 0;       ///< of the string there [v0]; 0 for a rod
};

/// Returns the exact state at any time, also after the end of the recording; without penetration and velocity
/// of the bit. At the section ξ = x/L and the global time t/t0. Requires an impact with Detail::histories.
RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t);

/// Returns the states of the bit at the times of sampleHistory(): `positiveWave` is the one that arrives; N
/// and the other wave are 0. Requires an impact with Detail::histories.
std::vector<RodState> sampledStates(const Impact& impact, const Problem& problem);

}  // namespace drillwave
