// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces at every section of the rod, with the times at which they occur (theory §3.1).
#pragma once

#include <stop_token>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Largest forces over the rod as points to be joined by straight lines, in their sizes and in their times,
/// from the struck end to the bit. A section occurs twice where the line jumps, or where the wave changes
/// that is the largest there.
using EnvelopeLine = std::vector<RodForce>;

/// A line for each that RodForces has.
struct RodEnvelope : OfLoads<EnvelopeLine> {
    RodForces largest;  ///< of the whole rod: the largest of each line
    double missed = 0;  ///< [F0] by how much a line may be too low where the work had an end, else 0
    long steps = 0;     ///< pairs of stretches of the two waves that were looked at
};

/// Returns the lines of the largest forces. Requires an impact solved with Detail::histories. Made of the
/// same instants as largestRodForces(), and exact where these are: a wave is a straight line between two of
/// them, and so is the sum of two such lines that pass each other, over the sections where they meet. A
/// smooth maximum may be missed by 2e-4 of the largest force. At a jump both sides count. The work is limited
/// to `mostSteps` for each of the lines, and ends early after a stop.
RodEnvelope rodEnvelope(const Impact& impact, const PulseForce& pulse, const std::stop_token& stop = {},
                        long mostSteps = 1'000'000);

/// Returns the largest force at the section ξ; size 0 where the line has no points.
RodForce forceAt(const EnvelopeLine& line, double section);

}  // namespace drillwave
