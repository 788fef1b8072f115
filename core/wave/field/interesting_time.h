// SPDX-License-Identifier: GPL-3.0-or-later
// Interval of time that a picture of a blow shows at first.
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Interval of time t/t0 since the start of the blow.
struct TimeSpan {
    double begin = 0;
    double end = 1;
    bool operator==(const TimeSpan&) const = default;
};

/// Returns the interval of time that a picture of a blow shows at first. It starts with the blow. It ends one
/// round trip after the last separation of bit and rock, or after the arrival of the end of the hammer force
/// if that is later. It leaves out most of a long flight before the first contact, and everything after a
/// dozen round trips. Requires an impact solved with Detail::events or more.
TimeSpan interestingTime(const Impact& impact, const PulseForce& pulse);

/// Returns the interval of time that a picture of a blow shows at first, in units of t0. `contact` is the
/// time from the first contact to the last separation; NaN if there is no contact. `arrival` is the time at
/// which the waves of the blow reach the bit. The interval ends one round trip after the later of `arrival`
/// and the end of `contact`. It leaves out most of a long flight before the contact, and is at most a dozen
/// round trips long.
TimeSpan interestingTime(const TimeSpan& contact, double arrival, double roundTrip);

}  // namespace drillwave
