// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/rod_instants.h"
#include "core/wave/impact.h"

namespace drillwave {

namespace {

// The largest force that both waves make together while a blow lasts, and where little of them must be looked
// at for it.

// For the files of this folder only; of an impact solved with Detail::histories.

// The largest of one sign of the force in the rod, as recorded times of the two waves that make it.
struct Meeting {
    double size = 0;  // [F0], ≥ 0
    double incident = 0, reflected = 0;

    void offer(double sum, const Instant& incoming, const Instant& back) {
        if (sum > size) *this = {sum, incoming.time, back.time};
    }
};

// The largest sum of one sign while the blow lasts. Almost all of both waves cannot be part of it: from
// whole pieces to parts of them, waves are left out that cannot reach the largest sum so far with
// anything that they meet. The rest is looked at in every part. Keeps its memory from one sign to the
// other.
class LargestMeeting {
  public:
    explicit LargestMeeting(const Impact& impact);

    // Finds the largest −N for a sign of 1, N for −1. `pieces` are whole, `ends` are their instants.
    Meeting find(double sign, const std::vector<WaveSpan>& pieces, const std::vector<Instant>& ends);
    // Returns the number of spans so far.
    long looked() const { return m_looked; }

  private:
    Meeting sumsOf(const std::vector<Instant>& instants);
    void addInTheBlow(const std::vector<Instant>& instants, Meeting& most);
    void addLast(const std::vector<Instant>& instants, Meeting& most) const;
    bool areInRod(const Instant& incoming, const Instant& reflected) const;
    void addCounterparts(const WaveSpan& span, std::vector<Instant>& instants) const;
    const std::vector<Instant>& instantsOf(const std::vector<WaveSpan>& spans);
    void keep(const std::vector<WaveSpan>& spans, double least);
    void sortOut(const std::vector<WaveSpan>& spans, double least);
    double rounding(const WaveSpan& span) const;
    std::size_t firstEndingAt(double time) const;
    std::size_t firstBeginningAfter(double time) const;
    std::size_t lastOverlappingSpan(std::size_t i) const;
    double lastToMeet(const WaveSpan& span) const;

    const Impact& m_impact;
    double m_end;      // of the blow, recorded time
    Instant m_before;  // what was in the rod before the first front
    double m_sign = 1;
    long m_looked = 0;

    std::vector<WaveSpan> m_left, m_parts;  // what may be part of the sum, and that in parts
    std::vector<Instant> m_instants;
    std::vector<Instant> m_back;  // from somewhere on falling values of the reflected wave
    std::vector<SpanBound> m_bounds;
    std::vector<const WaveSpan*> m_some;  // what is not sorted out by the largest of all
    std::vector<double> m_incident, m_reflected;
    RangeMaximum m_mostIncident, m_mostReflected;
};

LargestMeeting::LargestMeeting(const Impact& impact)
    : m_impact(impact), m_end(recordedEndOfBlow(impact)), m_before(instantBeforeFront(impact, 0)) {}

Meeting LargestMeeting::find(double sign, const std::vector<WaveSpan>& pieces,
                             const std::vector<Instant>& ends) {
    m_sign = sign;
    keep(pieces, sumsOf(ends).size);
    while (!std::ranges::all_of(m_left, &WaveSpan::isOnePart)) {
        cut(m_impact, m_left, m_parts);
        endsOf(m_parts, m_instants);
        keep(m_parts, sumsOf(m_instants).size);
    }
    return sumsOf(instantsOf(m_left));
}

/// Waves that the rear end has reflected by now are part of g already. A jump that returns there must not be
/// added to its former value: within rounding of one round trip only the later side of the earlier time and
/// the earlier side of the later one are in the rod together.
bool LargestMeeting::areInRod(const Instant& incoming, const Instant& reflected) const {
    const double oldest = incoming.time - m_impact.roundTrip;
    if (std::abs(reflected.time - oldest) > roundingOfTrip(incoming.time, m_impact.roundTrip))
        return reflected.time > oldest;
    return incoming.side == Side::end && reflected.side == Side::start;
}

/// Returns the largest sum over instants in order of time, all of which are instants of the blow.
Meeting LargestMeeting::sumsOf(const std::vector<Instant>& instants) {
    Meeting most;
    addInTheBlow(instants, most);
    addLast(instants, most);
    return most;
}

/// Until the blow is over: what comes in meets the largest of what went back up to one round trip before.
void LargestMeeting::addInTheBlow(const std::vector<Instant>& instants, Meeting& most) {
    std::size_t first = 0;
    m_back.clear();
    const auto pass = [&](const Instant& now) {
        while (m_back.size() > first && m_sign * m_back.back().reflected <= m_sign * now.reflected)
            m_back.pop_back();
        m_back.push_back(now);
        while (m_back.size() - first > 1 && !areInRod(now, m_back[first])) ++first;
        most.offer(m_sign * (now.incident + m_back[first].reflected), now, m_back[first]);
    };
    pass(m_before);
    for (const Instant& now : instants)
        if (now.time <= m_end) pass(now);
}

/// Waves that come in later than that meet those that left before 2·end − a only: a window that grows at
/// both of its ends as a goes back from end + τ to `end`.
void LargestMeeting::addLast(const std::vector<Instant>& instants, Meeting& most) const {
    const double half = m_impact.roundTrip / 2;
    const auto oldest = std::ranges::lower_bound(instants, m_end - 2 * half, {}, &Instant::time);
    const auto first = std::ranges::lower_bound(instants, m_end - half, {}, &Instant::time);
    const auto last = std::ranges::upper_bound(instants, m_end + half, {}, &Instant::time);
    auto low = first, high = first;  // [low, high) is in the window
    const Instant* largest = nullptr;
    const auto take = [&](const Instant& back) {
        if (!largest || m_sign * back.reflected > m_sign * largest->reflected) largest = &back;
    };
    for (auto now = std::make_reverse_iterator(last); now != instants.rend() && now->time > m_end; ++now) {
        while (high != last && high->time <= 2 * m_end - now->time && areInRod(*now, *high)) take(*high++);
        while (low != oldest && areInRod(*now, *(low - 1))) take(*--low);
        if (largest) most.offer(m_sign * (now->incident + largest->reflected), *now, *largest);
    }
}

/// With the counterparts of what meets them at the end of the blow.
const std::vector<Instant>& LargestMeeting::instantsOf(const std::vector<WaveSpan>& spans) {
    const double half = m_impact.roundTrip / 2;
    m_instants.clear();
    const WaveSpan* before = nullptr;
    for (const WaveSpan& span : spans) {
        if (!before || !follows(*before, span)) m_instants.push_back(span.begin);
        before = &span;
        if (span.end.time >= m_end - half && span.begin.time <= m_end + half)
            addCounterparts(span, m_instants);
        m_instants.push_back(span.end);
    }
    return m_instants;
}

void LargestMeeting::addCounterparts(const WaveSpan& span, std::vector<Instant>& instants) const {
    const double start = m_impact.incident.pieces()[span.piece].start;
    const double from = endOfPart(m_impact, span.piece, span.first, span.bends.parts);
    const double until = endOfPart(m_impact, span.piece, span.last, span.bends.parts);
    for (const double time : counterparts(m_impact, m_end, span.begin.time, span.end.time)) {
        const double x = time - start;
        if (time > start && x >= from && x < until)
            instants.push_back(instantIn(m_impact, span.piece, x, Side::inside));
    }
}

namespace {

bool suffices(double sum, double least) {
    return sum > 0 && sum >= least;
}

}  // namespace

/// Leaves what can be part of a sum of `least` or more: as the incoming wave, with the largest of what that
/// meets, or as the reflected one.
void LargestMeeting::keep(const std::vector<WaveSpan>& spans, double least) {
    m_looked += static_cast<long>(spans.size());
    sortOut(spans, least);
    m_mostIncident.assign(m_incident);
    m_mostReflected.assign(m_reflected);
    m_left.clear();
    for (std::size_t i = 0; i < m_some.size(); ++i) {
        const WaveSpan& span = *m_some[i];
        const double oldest = span.begin.time - m_impact.roundTrip - rounding(span);
        double met = m_mostReflected.over(firstEndingAt(oldest), lastOverlappingSpan(i));
        if (oldest <= 0) met = std::max(met, m_sign * m_before.reflected);
        const bool comesIn = suffices(m_incident[i] + met, least);
        const bool goesBack =
            suffices(m_reflected[i] + m_mostIncident.over(i, firstBeginningAfter(lastToMeet(span))), least);
        if (!comesIn && !goesBack) continue;
        m_left.push_back(span);
        m_left.back().cut = comesIn && goesBack ? Cut::middle
                            : comesIn           ? cutForIncident(span, m_sign)
                                                : cutForReflected(span, m_sign);
    }
}

/// At first by the largest of all, wherever that is: what is left out here meets nothing else.
void LargestMeeting::sortOut(const std::vector<WaveSpan>& spans, double least) {
    m_bounds.clear();
    SpanBound most{-std::numeric_limits<double>::infinity(), m_sign * m_before.reflected};
    for (const WaveSpan& span : spans) {
        const SpanBound& bound = m_bounds.emplace_back(boundOf(span, m_sign));
        most = {std::max(most.incident, bound.incident), std::max(most.reflected, bound.reflected)};
    }
    m_some.clear();
    m_incident.clear();
    m_reflected.clear();
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (!suffices(m_bounds[i].incident + most.reflected, least) &&
            !suffices(m_bounds[i].reflected + most.incident, least))
            continue;
        m_some.push_back(&spans[i]);
        m_incident.push_back(m_bounds[i].incident);
        m_reflected.push_back(m_bounds[i].reflected);
    }
}

double LargestMeeting::rounding(const WaveSpan& span) const {
    return 2 * roundingOfTrip(std::max(span.end.time, m_end), m_impact.roundTrip);
}

std::size_t LargestMeeting::firstEndingAt(double time) const {
    const auto found =
        std::ranges::partition_point(m_some, [time](const WaveSpan* span) { return span->end.time < time; });
    return static_cast<std::size_t>(found - m_some.begin());
}

std::size_t LargestMeeting::firstBeginningAfter(double time) const {
    const auto found = std::ranges::partition_point(
        m_some, [time](const WaveSpan* span) { return span->begin.time <= time; });
    return static_cast<std::size_t>(found - m_some.begin());
}

/// Behind the last span of which span number i may meet anything.
std::size_t LargestMeeting::lastOverlappingSpan(std::size_t i) const {
    const WaveSpan& span = *m_some[i];
    if (span.begin.time <= m_end) return i + 1;
    return std::min(i + 1, firstBeginningAfter(2 * m_end - span.begin.time + rounding(span)));
}

/// Until when something comes in that meets some of this span.
double LargestMeeting::lastToMeet(const WaveSpan& span) const {
    const double last = span.end.time + m_impact.roundTrip + rounding(span);
    if (last <= m_end) return last;
    return std::max(m_end, std::min(last, 2 * m_end - span.begin.time + rounding(span)));
}

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
