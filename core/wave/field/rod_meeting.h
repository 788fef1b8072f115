// SPDX-License-Identifier: GPL-3.0-or-later
// Where and when two waves meet in the rod (theory §3.1).
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

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
