// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/bit_history.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/wave/field/history_reader.h"

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

double bitDisplacement(const Impact& impact, double t) {
    assert(impact.hasHistories());
    const double s = t - impact.frontArrival;
    return incidentImpulse(impact, s) - impactImpulse(impact, s) / 2;
}

BitState bitState(const std::function<double(double)>& displacementAt,
                  std::span<const ContactInterval> contacts, double delta, double t) {
    const double displacement = displacementAt(t);
    const auto next =
        std::upper_bound(contacts.begin(), contacts.end(), t,
                         [](double time, const ContactInterval& contact) { return time < contact.begin; });
    if (next == contacts.begin()) return {false, 0, std::max(0.0, delta - displacement)};
    const ContactInterval& last = *std::prev(next);
    if (t <= last.end) return {true, displacement - delta, 0};
    return {false, 0, std::max(0.0, displacementAt(last.end) - displacement)};
}

BitState bitState(const Impact& impact, std::span<const ContactInterval> contacts, double delta, double t) {
    return bitState([&](double time) { return bitDisplacement(impact, time); }, contacts, delta, t);
}

}  // namespace drillwave
