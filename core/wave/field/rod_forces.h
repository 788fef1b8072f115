// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in the rod, wherever and whenever they occur (theory §3.1).
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/section_forces.h"

namespace drillwave {

/// A largest normal force in the rod, and one place and time at which it occurs (others may have the same).
struct RodForce {
    double size = 0;     ///< |N|/F0, ≥ 0
    double section = 0;  ///< ξ = x/L: rear end 0, front end 1
    double time = 0;     ///< global time t/t0
    bool operator==(const RodForce&) const = default;
};

/// Of −N and of N while the blow lasts, to one transit after the last separation; later of the waves left,
/// which nothing damps in the model, with time and place of their first meeting. Sizes are 0 where the rod is
/// never pushed or pulled.
using RodForces = OfLoads<RodForce>;

/// Which of them are wanted; the others stay 0.
struct RodForceChoice {
    bool compression = true, tension = true, after = true;
};

/// The largest of −N and of N = Np + Nn over the whole rod, during the blow and of the waves that run on
/// after it. Of an impact solved with Detail::histories.
///
/// N(ξ, t) = −g(a) − r(b) with r = F − g, a = t − ξτ and b = t − (2 − ξ)τ: every pair of times 0 ≤ a − b ≤ 2τ
/// meets at some section at t = (a + b)/2 + τ, so it is a sliding maximum of r that is added to g. Exact at
/// breakpoints and jumps; a maximum inside a smooth piece may be missed by 2e-4 of the peak force. Where the
/// waves cannot be large enough they are not looked at: `looked` is raised by the stretches that were.
RodForces largestRodForces(const Impact& impact, const PulseForce& pulse, const RodForceChoice& choice = {},
                           long* looked = nullptr);

// Where and when two waves meet in the rod (theory §3.1).

// For the files of this folder only; of an impact solved with Detail::histories.

/// A force of that size made by what comes to the front end at the recorded time `incident` [t0] and what has
/// left it `delay` earlier, 0 ≤ delay ≤ 2τ: they are at 1 − ξ = delay/2τ together.
RodForce meetingInRod(const Impact& impact, double size, double incident, double delay);

/// The same of waves that repeat themselves with 2τ: the first such meeting from the global time `begin` on.
RodForce laterMeetingInRod(const Impact& impact, double size, double incident, double delay, double begin);

/// From when on only the waves that are left run through the rod: one transit after the last separation and
/// after the end of the hammer force, as global time.
double startOfWavesLeft(const Impact& impact, const PulseForce& pulse);

/// The peak of the hammer force, which at the rear end is the force in the rod.
RodForce hammerPeak(const PulseForce& pulse);

}  // namespace drillwave
