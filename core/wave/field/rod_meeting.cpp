// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_meeting.h"

#include <algorithm>
#include <cmath>

#include "core/wave/field/bit_history.h"

namespace drillwave {

RodForce meetingInRod(const Impact& impact, double size, double incident, double delay) {
    const double late = std::clamp(delay / impact.roundTrip, 0.0, 1.0);  // 1 − ξ
    const double time = timeOfRecorded(impact, incident) + impact.frontArrival - late * impact.roundTrip / 2;
    return {size, 1 - late, time};
}

RodForce laterMeetingInRod(const Impact& impact, double size, double incident, double delay, double begin) {
    RodForce force = meetingInRod(impact, size, incident, delay);
    force.time += std::ceil((begin - force.time) / impact.roundTrip) * impact.roundTrip;
    return force;
}

double startOfWavesLeft(const Impact& impact, const PulseForce& pulse) {
    const double transit = impact.roundTrip / 2;
    return std::max(impact.separationTime, impact.frontArrival + pulse.end) + transit;
}

RodForce hammerPeak(const PulseForce& pulse) {
    double time = 0;
    for (const PulseSegment& segment : pulse.segments) {
        // Its ends, and the middle of a half sine.
        for (const double part : {0.0, 0.5, 1.0}) {
            const double t = segment.start + part * segment.length;
            if (pulse(t) > pulse(time)) time = t;
        }
    }
    return {pulse.peak, 0, time};
}

}  // namespace drillwave
