// SPDX-License-Identifier: GPL-3.0-or-later
// The state of rod or string during a blow at one instant.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Momentum of the rod, p = ∫Fa dt − ∫F ds [I0] (T20), towards the rock positive, at the global time t/t0:
/// what the hammer has given it less `taken`, the impulse of the impact force so far. In the reference case
/// it is given before the first contact.
double rodMomentum(const PulseForce& pulse, double t, double taken);

/// The same, the impulse of the impact force being looked up. Needs an impact solved with Detail::histories.
double rodMomentum(const Impact& impact, const PulseForce& pulse, double t);

/// Normal forces are positive in tension, everything else towards the rock; what is not told of a uniform rod
/// is 0. Times in t0, forces in F0; where two units stand, the first one is that of a rod, the other that of
/// a string.
struct RodState {
    double time = 0;
    double impactForce = 0;    ///< F ≥ 0 of bit and rock
    double impulse = 0;        ///< ∫F so far [I0; p0 of a hammer that is followed]
    double momentum = 0;       ///< what it was given less that, likewise: p where nothing is lost (T20)
    double penetration = 0;    ///< of the bit below the first surface of the rock [d0; v0 t0]
    double frontVelocity = 0;  ///< of the bit [d0/t0; v0]
    double faceForce = 0;      ///< of hammer and string ≥ 0; not told of a rod
    double normalForce = 0;    ///< N at the section (T2)
    double positiveWave = 0;   ///< Np there, which runs to the bit
    double negativeWave = 0;   ///< Nn there, which comes back
    double velocity = 0;       ///< of the string there [v0]; not told of a rod
};

/// Exact at any time, also behind the end of the recording; without penetration and velocity of the bit. At
/// the section ξ = x/L and the global time t/t0. Needs an impact solved with Detail::histories.
RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t);

/// What is at the bit at the times of sampleHistory(): `positiveWave` is the one that arrives there, the
/// force N and the other wave are not told. Likewise.
std::vector<RodState> sampledStates(const Impact& impact, const Problem& problem);

}  // namespace drillwave
