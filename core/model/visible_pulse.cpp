// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/visible_pulse.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

using Kind = PulseSegment::Kind;

/// Share of the impulse after which momentum and waves look as they do at the end: 3 % are a few pixels of a
/// plot.
constexpr double visibleShare = 0.97;

/// The force e^−t is below one percent of its peak from here on, in t0.
constexpr double decayed = 5;

/// Share of the peak below which a step of a staircase is cut off: a pixel of a small plot.
constexpr double negligibleStep = 0.02;

/// Chords to a curved segment: their bends cannot be seen.
constexpr int chords = 48;

/// How far into a segment a share of its samples lies, as a fraction of its length or, where the force
/// decays, of its impulse.
double localTime(const PulseSegment& segment, double share) {
    if (segment.kind != Kind::exponential) return segment.length * share;
    return share < 1 ? std::min(-std::log1p(-share), segment.length) : segment.length;
}

}  // namespace

std::vector<double> impulseTimes(const PulseForce& pulse) {
    std::vector<double> times{0};
    for (const PulseSegment& segment : pulse.segments) {
        const bool straight = segment.kind == Kind::linear && segment.slope == 0;
        const int samples = straight ? 1 : chords;
        for (int i = 1; i <= samples; ++i)
            times.push_back(segment.start + localTime(segment, static_cast<double>(i) / samples));
    }
    return times;
}

double visibleImpulseEnd(const PulseForce& pulse) {
    for (const double time : impulseTimes(pulse))
        if (pulse.impulseUntil(time) >= visibleShare) return time;
    return pulse.end;
}

double visibleWavesEnd(const PulseForce& pulse) {
    for (const PulseSegment& segment : pulse.segments)
        if (segment.kind == Kind::exponential)
            return segment.start - std::log1p(-visibleShare);
        else if (pulse.impulseUntil(segment.start + segment.length) >= visibleShare)
            return segment.start + segment.length;
    return pulse.end;
}

double visibleForceEnd(const PulseForce& pulse) {
    if (pulse.shape == PulseShape::exponential) return decayed;
    if (pulse.shape != PulseShape::piston) return pulse.end;
    const auto small = std::ranges::find_if(
        pulse.segments, [&](const PulseSegment& step) { return step.value < negligibleStep * pulse.peak; });
    return small == pulse.segments.end() ? pulse.end : small->start;
}

}  // namespace drillwave
