// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/interesting_time.h"

#include <algorithm>

#include "core/model/pulse_force.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {
namespace {

constexpr double mostFlightShown = 6;  // round trips before the first contact that are shown from the start
constexpr double mostRoundTrips = 12;

}  // namespace

TimeSpan interestingTime(const Impact& impact, const PulseForce& pulse) {
    const RodDelays delays(impact);
    return interestingTime({impact.firstContactTime, impact.separationTime},
                           std::max(visibleWavesEnd(pulse), delays.arrival()), delays.roundTrip());
}

TimeSpan interestingTime(const TimeSpan& contact, double arrival, double roundTrip) {
    const bool longFlight = contact.begin > mostFlightShown * roundTrip;
    const double begin = longFlight ? contact.begin - 1.5 * roundTrip : 0;
    const double last = contact.end > arrival ? contact.end : arrival;  // there may be no contact at all
    return {begin, std::min(last + roundTrip, begin + mostRoundTrips * roundTrip)};
}

}  // namespace drillwave
