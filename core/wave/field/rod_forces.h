// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in the rod, wherever and whenever they occur (theory §3.1).
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/section_forces.h"

namespace drillwave {

/// Largest normal force in the rod, with one place and time at which it occurs (others may have the same).
struct RodForce {
    double size = 0;     ///< |N|/F0, ≥ 0
    double section = 0;  ///< ξ = x/L: rear end 0, front end 1
    double time = 0;     ///< global time t/t0
    bool operator==(const RodForce&) const = default;
};

/// Largest −N and N while the blow lasts, to one transit after the last separation; later those of the
/// residual waves, which nothing damps in the model, with time and place of their first meeting. Sizes are 0
/// where the rod is never pushed or pulled.
using RodForces = OfLoads<RodForce>;

/// Selected forces; the others stay 0.
struct RodForceChoice {
    bool compression = true, tension = true, after = true;
};

/// Returns the largest −N and N = Np + Nn over the whole rod, during the blow and of the residual waves after
/// it. Requires an impact solved with Detail::histories.
///
/// N(ξ, t) = −g(a) − r(b) with r = F − g, a = t − ξτ and b = t − (2 − ξ)τ: every pair of times 0 ≤ a − b ≤ 2τ
/// meets at some section at t = (a + b)/2 + τ, so a sliding maximum of r is added to g. Exact at breakpoints
/// and jumps; a maximum inside a smooth piece may be missed by 2e-4 of the peak force. Stretches whose waves
/// are not large enough are skipped; `looked` is raised by the number of the others.
RodForces largestRodForces(const Impact& impact, const PulseForce& pulse, const RodForceChoice& choice = {},
                           long* looked = nullptr);

// Place and time where two waves meet in the rod (theory §3.1).

// For the files of this folder only; requires an impact solved with Detail::histories.

/// Returns a force of that size, made by the wave that reaches the front end at the recorded time `incident`
/// [t0] and the one that left it `delay` earlier, 0 ≤ delay ≤ 2τ: they meet at 1 − ξ = delay/2τ.
RodForce meetingInRod(const Impact& impact, double size, double incident, double delay);

/// Returns the same for waves that repeat with 2τ: the first such meeting from the global time `begin` on.
RodForce laterMeetingInRod(const Impact& impact, double size, double incident, double delay, double begin);

/// Returns the global time from which only the residual waves run through the rod: one transit after the last
/// separation and after the end of the hammer force.
double startOfWavesLeft(const Impact& impact, const PulseForce& pulse);

/// The peak of the hammer force, which at the rear end is the force in the rod.
RodForce hammerPeak(const PulseForce& pulse);

}  // namespace drillwave
