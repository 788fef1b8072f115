// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_fronts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace drillwave {
namespace {

double valueAtEnd(const PulseSegment& segment) {
    switch (segment.kind) {
        case PulseSegment::Kind::linear:
            return segment.value + segment.slope * segment.length;
        case PulseSegment::Kind::sine:
            return 0;
        case PulseSegment::Kind::exponential:
            return segment.value * std::exp(-segment.length);
    }
    return 0;
}

}  // namespace

std::vector<double> pulseFronts(const PulseForce& pulse) {
    constexpr double visible = 0.02;
    std::vector<double> fronts{0};
    double before = 0;
    for (const PulseSegment& segment : pulse.segments) {
        if (segment.start > 0 && std::abs(pulse(segment.start) - before) >= visible * pulse.peak)
            fronts.push_back(segment.start);
        before = valueAtEnd(segment);
    }
    const bool fades = pulse.shape == PulseShape::exponential || pulse.shape == PulseShape::piston;
    if (!pulse.segments.empty() && (!fades || before >= visible * pulse.peak)) fronts.push_back(pulse.end);
    return fronts;
}

std::vector<FrontRun> frontRuns(const Impact& impact, double start, double begin, double end) {
    const RodDelays delays(impact);
    const double transit = delays.transitTime(), first = delays.arrival() + start;
    const double firstTrip = std::max(0.0, std::ceil((begin - transit - first) / delays.roundTrip()));
    const double lastTrip = std::floor((end + transit - first) / delays.roundTrip());
    const bool startsAtBit = delays.arrival() == 0;  // the reference case
    std::vector<FrontRun> runs;
    for (double trip = firstTrip; trip <= lastTrip; ++trip) {
        const double timeAtBit = first + trip * delays.roundTrip();
        const long number = 2 * static_cast<long>(trip);
        if (trip > 0 || !startsAtBit) runs.push_back({number, Heading::toBit, timeAtBit, transit});
        runs.push_back({number + 1, Heading::fromBit, timeAtBit, transit});
    }
    return runs;
}

std::vector<ContactInterval> contactIntervals(const Impact& impact) {
    assert(impact.hasEvents());
    std::vector<ContactInterval> intervals;
    bool touching = false;
    for (const ImpactEvent& event : impact.events) {
        if (event.kind == ContactEvent::contact && !touching) {
            intervals.push_back({event.time, event.time});
            touching = true;
        } else if (event.kind == ContactEvent::separation && touching) {
            intervals.back().end = event.time;
            touching = false;
        }
    }
    if (touching) intervals.back().end = impact.separationTime;
    return intervals;
}

}  // namespace drillwave
