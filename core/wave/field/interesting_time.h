// SPDX-License-Identifier: GPL-3.0-or-later
// The time in which something happens in the rod that is worth looking at.
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// A stretch of global time t/t0.
struct TimeSpan {
    double begin = 0;
    double end = 1;
    bool operator==(const TimeSpan&) const = default;
};

/// Returns the span from the beginning of a blow to a round trip after its last separation. Leaves out most
/// of a long flight before the first contact, and everything later than a dozen round trips. Requires an
/// impact solved with Detail::events or more.
TimeSpan interestingTime(const Impact& impact, const PulseForce& pulse);

/// Returns the span from the first contact of bit and rock to their last separation (NaN where they never
/// meet), at least to when the waves of the blow have arrived.
TimeSpan interestingTime(const TimeSpan& contact, double arrival, double roundTrip);

}  // namespace drillwave
