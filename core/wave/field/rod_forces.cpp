// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/wave/field/largest_meeting.h"
#include "core/wave/field/rod_instants.h"
#include "core/wave/field/rod_meeting.h"
#include "core/wave/field/wave_spans.h"

namespace drillwave {

namespace {

/// The first instant of the last period, whose pieces these are, at which the incident wave, times `sign`, is
/// largest.
Instant largestOfLastPeriod(const Impact& impact, double sign, std::vector<WaveSpan> spans) {
    const double from = impact.incident.end() - impact.roundTrip;
    Instant most{};
    double size = -std::numeric_limits<double>::infinity();
    const auto offer = [&](const Instant& now) {
        if (now.time >= from && sign * now.incident > size) most = now, size = sign * now.incident;
    };
    for (std::vector<WaveSpan> parts;; cut(impact, spans, parts), spans.swap(parts)) {
        for (const WaveSpan& span : spans) offer(span.begin), offer(span.end);
        std::erase_if(spans, [&](const WaveSpan& each) { return boundOf(each, sign).incident < size; });
        if (std::ranges::all_of(spans, &WaveSpan::isOnePart)) break;
        for (WaveSpan& span : spans) span.cut = cutForIncident(span, sign);
    }
    size = -std::numeric_limits<double>::infinity();
    for (const WaveSpan& span : spans) {
        offer(span.begin);
        const double x = from - impact.incident.pieces()[span.piece].start;
        if (span.begin.time < from && from < span.end.time)
            offer(instantIn(impact, span.piece, x, Side::inside));
        offer(span.end);
    }
    return most;
}

/// After the blow the waves run to and fro: each point of them meets every other, the first time after
/// `begin`.
void addWavesThatRemain(const Impact& impact, const std::vector<WaveSpan>& period, double begin,
                        RodForces& forces) {
    const Instant least = largestOfLastPeriod(impact, -1, period);
    const Instant most = largestOfLastPeriod(impact, 1, period);
    const double size = most.incident - least.incident;
    if (!(size > 0)) return;
    const auto meeting = [&](const Instant& incoming, const Instant& reflected) {
        const double delay = std::fmod(incoming.time - reflected.time + impact.roundTrip, impact.roundTrip);
        return laterMeetingInRod(impact, size, incoming.time, delay, begin);
    };
    forces.compressionAfter = meeting(most, least);
    forces.tensionAfter = meeting(least, most);
}

}  // namespace

RodForces largestRodForces(const Impact& impact, const PulseForce& pulse, const RodForceChoice& choice,
                           long* looked) {
    RodForces forces;
    const double period = impact.incident.end() - impact.roundTrip;
    const double lastMeeting = recordedEndOfBlow(impact) + impact.roundTrip / 2;
    const bool during = choice.compression || choice.tension;
    std::vector<WaveSpan> pieces =
        wholePieces(impact, during ? 0 : period, choice.after ? impact.incident.end() : lastMeeting);
    if (choice.after) {
        const auto first = std::ranges::partition_point(
            pieces, [period](const WaveSpan& each) { return each.end.time < period; });
        addWavesThatRemain(impact, {first, pieces.end()}, startOfWavesLeft(impact, pulse), forces);
    }
    if (during) {
        const auto behind = std::ranges::partition_point(
            pieces, [lastMeeting](const WaveSpan& each) { return each.begin.time <= lastMeeting; });
        pieces.erase(behind, pieces.end());
        std::vector<Instant> ends;
        endsOf(pieces, ends);
        LargestMeeting search(impact);
        const auto find = [&](double sign) {
            const Meeting found = search.find(sign, pieces, ends);
            return meetingInRod(impact, found.size, found.incident, found.incident - found.reflected);
        };
        if (choice.compression) forces.compression = find(1);
        if (choice.tension) forces.tension = find(-1);
        if (looked) *looked += search.looked();
    }
    if (choice.compression && pulse.peak > forces.compression.size) forces.compression = hammerPeak(pulse);
    return forces;
}

}  // namespace drillwave
