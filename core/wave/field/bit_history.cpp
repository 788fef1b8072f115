// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/bit_history.h"

#include <algorithm>
#include <cmath>

#include "core/wave/field/recorded_time.h"

namespace drillwave {
namespace {

/// ∫g over `duration` of the periods that repeat the one before the recorded time `end`.
double repeatedImpulse(const Impact& impact, double end, double duration) {
    const double begin = impact.incident.integral(end - impact.roundTrip);
    const double periods = std::floor(duration / impact.roundTrip);
    const double rest = duration - periods * impact.roundTrip;
    return periods * (impact.incident.integral(end) - begin) +
           impact.incident.integral(end - impact.roundTrip + rest) - begin;
}

}  // namespace

double incidentWave(const Impact& impact, double s) {
    if (s < 0) return waveBeforeArrival(impact);
    return impact.incident(recordedTime(impact, s));
}

double impactForce(const Impact& impact, double s) {
    return s < 0 ? 0.0 : impact.force(recordedTime(impact, s));
}

double impactImpulse(const Impact& impact, double s) {
    if (s <= 0) return 0;
    return impact.force.integral(recordedTime(impact, s));
}

double incidentImpulse(const Impact& impact, double s) {
    if (s <= 0) return s * waveBeforeArrival(impact);
    double repeated = 0, leftOut = 0;
    for (const PeriodSkip& skip : impact.skips) {
        if (s < skip.start) break;
        const double recorded = skip.start - leftOut;
        repeated += repeatedImpulse(impact, recorded, std::min(s - skip.start, skip.duration));
        if (s < skip.start + skip.duration) return impact.incident.integral(recorded) + repeated;
        leftOut += skip.duration;
    }
    const double recorded = s - leftOut, end = impact.incident.end();
    if (recorded > end && impact.roundTrip > 0) repeated += repeatedImpulse(impact, end, recorded - end);
    return impact.incident.integral(recorded) + repeated;
}

double timeOfRecorded(const Impact& impact, double recorded) {
    return recorded + unrecordedBefore(impact, recorded);
}

}  // namespace drillwave
