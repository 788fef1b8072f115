// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in the rod, wherever and whenever they occur (theory §3.1).
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "core/wave/section_forces.h"

namespace drillwave {

/// Largest normal force in the rod, with one section and time at which it occurs. Other sections and times
/// may have the same force.
struct RodForce {
    /// Magnitude |N|/F0 of the normal force; ≥ 0.
    double size = 0;
    /// Section ξ = x/L at which the force occurs: rear end 0, front end 1.
    double section = 0;
    /// Time t/t0 of the force since the start of the blow.
    double time = 0;
    bool operator==(const RodForce&) const = default;
};

/// Largest compression −N and tension N in the rod, during and after the blow. The blow lasts until one
/// transit of the rod after the last separation of bit and rock. The residual waves after it are undamped in
/// the model and meet again and again; time and section are those of the first meeting. Sizes are 0 if the
/// rod is never compressed or stretched.
using RodForces = OfLoads<RodForce>;

/// Selection of the forces to compute: compression and tension during the blow, and both after it. Forces
/// that are not selected stay 0.
struct RodForceChoice {
    bool compression = true, tension = true, after = true;
};

/// Returns the largest compression −N and tension N = Np + Nn over the whole rod, during the blow and after
/// it. Requires an impact solved with Detail::histories.
///
/// N(ξ, t) = −g(a) − r(b) with r = F − g, a = t − ξτ and b = t − (2 − ξ)τ. For any two times with 0 ≤ a − b ≤
/// 2τ, the waves g(a) and r(b) meet at some section, at the time t = (a + b)/2 + τ. The search therefore adds
/// to each g(a) the largest r of the round trip before a. The result is exact at breakpoints and jumps; a
/// maximum inside a smooth piece may be missed by 2e-4 of the peak force. Intervals of time in which both
/// waves are too small are skipped. If `looked` is given, the number of examined intervals is added to it.
RodForces largestRodForces(const Impact& impact, const PulseForce& pulse, const RodForceChoice& choice = {},
                           long* looked = nullptr);

// Section and time at which two waves meet in the rod (theory §3.1).

// For the files of this folder only; requires an impact solved with Detail::histories.

/// Returns a force with the value `size`, and with the section and time at which the two waves that cause it
/// meet. One wave reaches the front end at the recorded time `incident`; the other left the front end
/// earlier, by `delay` (0 … 2τ). They meet at 1 − ξ = delay/2τ. Times are in units of t0.
RodForce meetingInRod(const Impact& impact, double size, double incident, double delay);

/// Returns a force of the given size, with the section and time at which the two residual waves that cause it
/// meet. `incident` and `delay` describe these waves as in meetingInRod(). Since they repeat with 2τ, the
/// time is that of their first meeting at or after `begin`, in units of t0 since the start of the blow.
RodForce laterMeetingInRod(const Impact& impact, double size, double incident, double delay, double begin);

/// Returns the time t/t0 since the start of the blow from which only residual waves run through the rod. It
/// is one transit of the rod after the later of two events: the last separation of bit and rock, and the
/// arrival of the end of the hammer force at the bit.
double startOfWavesLeft(const Impact& impact, const PulseForce& pulse);

/// Returns the peak of the hammer force as a force in the rod, at the rear end ξ = 0, with its time.
RodForce hammerPeak(const PulseForce& pulse);

}  // namespace drillwave
