// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/largest_meeting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

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

/// What is reflected at the rear end by now is in g already. A jump that comes back there must not be added
/// to what it was before: within rounding of one round trip only the later side of the earlier time and the
/// earlier side of the later one are in the rod together.
bool LargestMeeting::areInRod(const Instant& incoming, const Instant& reflected) const {
    const double oldest = incoming.time - m_impact.roundTrip;
    if (std::abs(reflected.time - oldest) > roundingOfTrip(incoming.time, m_impact.roundTrip))
        return reflected.time > oldest;
    return incoming.side == Side::end && reflected.side == Side::start;
}

/// Of instants in order of time, all of which are instants of the blow.
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
        double met = m_mostReflected.over(firstEndingAt(oldest), behindMet(i));
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
std::size_t LargestMeeting::behindMet(std::size_t i) const {
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

}  // namespace drillwave
