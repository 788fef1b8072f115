// SPDX-License-Identifier: GPL-3.0-or-later
// Largest forces at every section of the rod, with the times at which they occur (theory §3.1).
#pragma once

#include <stop_token>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Largest force at every section of the rod, as points from the struck end to the bit. Force and time are
/// interpolated linearly between two points. Two points have the same section where the force or its time
/// jumps.
using EnvelopeLine = std::vector<RodForce>;

/// Largest forces at every section of the rod, as four lines: compression and tension, each during and after
/// the blow.
struct RodEnvelope : OfLoads<EnvelopeLine> {
    /// Largest force of each of the four lines, over the whole rod.
    RodForces largest;
    /// Amount, in units of F0, by which a line of largest forces may be too low because pairs of wave
    /// stretches were left out (`mostSteps` or a stop request); otherwise 0.
    double missed = 0;
    /// Number of pairs of wave stretches examined, a measure of the work.
    long steps = 0;
};

/// Returns the largest forces at every section of the rod, during and after the blow. The waves are
/// approximated by straight lines between the instants of largestRodForces(); a smooth maximum may therefore
/// be too low by 2e-4 of the largest force. At a jump of a wave, the values on both sides count. Each of the
/// four lines takes at most `mostSteps` pairs of wave stretches; a stop request ends the work early. Requires
/// an impact solved with Detail::histories.
RodEnvelope rodEnvelope(const Impact& impact, const PulseForce& pulse, const std::stop_token& stop = {},
                        long mostSteps = 1'000'000);

/// Returns the largest force at the section ξ = x/L, interpolated between the points of the line; size 0 if
/// there are none.
RodForce forceAt(const EnvelopeLine& line, double section);

}  // namespace drillwave
