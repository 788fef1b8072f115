// SPDX-License-Identifier: GPL-3.0-or-later
// State of rod or string during a blow at one instant.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Returns the momentum of the rod, p = ∫Fa dt − ∫F ds (T20), in units of I0, positive towards the rock. The
/// first integral is the impulse of the hammer force up to the time t/t0 since the start of the blow. The
/// second one is `taken`, the impulse of the impact force until then. In the reference case (a rod that
/// arrives as a rigid body) the rod has its momentum 1 from the start.
double rodMomentum(const PulseForce& pulse, double t, double taken);

/// Returns the momentum of the rod at the time t/t0, in units of I0, positive towards the rock: the impulse
/// of the hammer force less that of the impact force. Requires an impact solved with Detail::histories.
double rodMomentum(const Impact& impact, const PulseForce& pulse, double t);

/// State of bit, rod and rock at one time. Normal forces are positive in tension, all other quantities
/// towards the rock. Fields that a uniform rod does not have are 0. Times are in t0 and forces in F0. Where
/// two units are given, the first one is for a uniform rod, the second one for a drill string.
struct RodState {
    /// Time t/t0 since the start of the blow.
    double time = 0;
    /// Impact force F/F0 between bit and rock; ≥ 0.
    double impactForce = 0;
    /// Impulse of the impact force so far, ∫F dt, in units of I0 (uniform rod) or of the hammer's momentum p0
    /// (drill string).
    double impulse = 0;
    /// Impulse that the hammer has transferred so far, less the impulse of the impact force, in units of I0
    /// (uniform rod) or p0 (drill string). Without losses it is the momentum of rod or string (T20).
    double momentum = 0;
    /// Penetration of the bit below the original surface of the rock, in units of d0 (uniform rod) or v0 t0
    /// (drill string); negative before the bit reaches it.
    double penetration = 0;
    /// Velocity of the bit towards the rock, in units of d0/t0 (uniform rod) or v0 (drill string).
    double frontVelocity = 0;
    /// Force between hammer and string, in units of F0; ≥ 0. It is 0 for a uniform rod.
    double faceForce = 0;
    /// Normal force N/F0 at the section, tension positive (T2).
    double normalForce = 0;
    /// Wave Np/F0 at the section, which runs towards the bit; tension positive.
    double positiveWave = 0;
    /// Wave Nn/F0 at the section, which runs towards the hammer; tension positive.
    double negativeWave = 0;
    /// Particle velocity of the string at the section, in units of v0; 0 for a uniform rod.
    double velocity = 0;
};

/// Returns the exact state of a uniform rod at the section ξ = x/L and the time t/t0 since the start of the
/// blow. The time may be after the end of the recording. Penetration and velocity of the bit are left at 0.
/// Requires an impact with Detail::histories.
RodState rodState(const Impact& impact, const PulseForce& pulse, double xi, double t);

/// Returns the states of the bit of a uniform rod at the times of sampleHistory(). `positiveWave` is the wave
/// that arrives at the bit; `normalForce` and `negativeWave` are left at 0. Requires an impact with
/// Detail::histories.
std::vector<RodState> sampledStates(const Impact& impact, const Problem& problem);

}  // namespace drillwave
