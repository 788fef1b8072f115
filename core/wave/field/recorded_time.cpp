// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/recorded_time.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

double recordedTime(const Impact& impact, double s) {
    double leftOut = 0;
    for (const PeriodSkip& skip : impact.skips) {
        if (s < skip.start) break;
        if (s < skip.start + skip.duration)
            return skip.start - leftOut - impact.roundTrip + std::fmod(s - skip.start, impact.roundTrip);
        leftOut += skip.duration;
    }
    s -= leftOut;
    const double end = impact.incident.end();
    if (s >= end && impact.roundTrip > 0)
        return end - impact.roundTrip + std::fmod(s - end, impact.roundTrip);
    return s;
}

double uninterrupted(const Impact& impact, double s) {
    for (const PeriodSkip& skip : impact.skips) {
        if (s < skip.start) return skip.start - s;
        const double end = skip.start + skip.duration;
        if (s < end) return std::min(end - s, impact.roundTrip - std::fmod(s - skip.start, impact.roundTrip));
    }
    return impact.incident.end() - recordedTime(impact, s);
}

double unrecordedBefore(const Impact& impact, double recorded) {
    double leftOut = 0;
    for (const PeriodSkip& skip : impact.skips) {
        if (recorded + leftOut < skip.start) break;
        leftOut += skip.duration;
    }
    return leftOut;
}

double waveBeforeArrival(const Impact& impact) {
    return impact.frontArrival == 0 && impact.roundTrip > 0 ? 1 / impact.roundTrip : 0.0;
}

}  // namespace drillwave
