// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/interesting_time.h"

#include <algorithm>

#include "core/model/visible_pulse.h"
#include "core/wave/field/rod_delays.h"

namespace drillwave {
namespace {

constexpr double mostFlightShown = 6;  // round trips before the first contact that are shown from the start
constexpr double mostRoundTrips = 12;

}  // namespace

TimeSpan interestingTime(const Impact& impact, const PulseForce& pulse) {
    const RodDelays delays(impact);
    const double roundTrip = delays.roundTrip();
    const bool longFlight = impact.firstContactTime > mostFlightShown * roundTrip;
    const double begin = longFlight ? impact.firstContactTime - 1.5 * roundTrip : 0;
    const double end =
        std::max({impact.separationTime, visibleWavesEnd(pulse), delays.arrival()}) + roundTrip;
    return {begin, std::min(end, begin + mostRoundTrips * roundTrip)};
}

}  // namespace drillwave
