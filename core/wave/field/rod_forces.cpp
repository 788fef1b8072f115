// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/wave/field/rod_instants.h"
#include "core/wave/field/rod_meeting.h"
#include "core/wave/field/wave_spans.h"

namespace drillwave {

namespace {

/// What is reflected at the rear end by now is in g already. A jump that comes back there must not be added
/// to what it was before: within rounding of one round trip only the later side of the earlier time and the
/// earlier side of the later one are in the rod together.
bool areInRod(const Instant& incoming, const Instant& reflected, double roundTrip) {
    const double oldest = incoming.time - roundTrip;
    if (std::abs(reflected.time - oldest) > roundingOfTrip(incoming.time, roundTrip))
        return reflected.time > oldest;
    return incoming.side == Side::end && reflected.side == Side::start;
}

/// The largest of one sign of the force in the rod, as recorded times of the two waves that make it.
struct Meeting {
    double size = 0;
    double incident = 0, reflected = 0;

    void offer(double sum, const Instant& incoming, const Instant& back) {
        if (sum > size) *this = {sum, incoming.time, back.time};
    }

    /// As a place and a global time.
    RodForce found(const Impact& impact) const {
        return meetingInRod(impact, size, incident, incident - reflected);
    }
};

/// Follows one sign of the force: the sum of what comes in and the largest of what went back up to one round
/// trip before.
class SlidingMaximum {
  public:
    SlidingMaximum(double sign, double roundTrip, Meeting& most)
        : m_sign(sign), m_roundTrip(roundTrip), m_most(most) {
        m_back.reserve(256);
    }

    void pass(const Instant& now) {
        while (m_back.size() > m_first && m_sign * m_back.back().reflected <= m_sign * now.reflected)
            m_back.pop_back();
        m_back.push_back(now);
        while (m_back.size() - m_first > 1 && !areInRod(now, m_back[m_first], m_roundTrip)) ++m_first;
        m_most.offer(m_sign * (now.incident + m_back[m_first].reflected), now, m_back[m_first]);
    }

  private:
    double m_sign;
    double m_roundTrip;
    Meeting& m_most;
    std::vector<Instant> m_back;  ///< from m_first on falling values of the reflected wave
    std::size_t m_first = 0;
};

/// Waves that come in later than `end` meet those that left before 2·end − a only: a window that grows at
/// both of its ends as a goes back from end + τ to `end`.
void addLastMeetings(const std::vector<Instant>& instants, double end, double roundTrip, double sign,
                     Meeting& most) {
    const auto oldest = std::ranges::lower_bound(instants, end - roundTrip, {}, &Instant::time);
    const auto first = std::ranges::lower_bound(instants, end - roundTrip / 2, {}, &Instant::time);
    const auto last = std::ranges::upper_bound(instants, end + roundTrip / 2, {}, &Instant::time);
    auto low = first, high = first;  // [low, high) is in the window
    const Instant* largest = nullptr;
    const auto take = [&](const Instant& back) {
        if (!largest || sign * back.reflected > sign * largest->reflected) largest = &back;
    };
    for (auto now = std::make_reverse_iterator(last); now != instants.rend() && now->time > end; ++now) {
        while (high != last && high->time <= 2 * end - now->time && areInRod(*now, *high, roundTrip))
            take(*high++);
        while (low != oldest && areInRod(*now, *(low - 1), roundTrip)) take(*--low);
        if (largest) most.offer(sign * (now->incident + largest->reflected), *now, *largest);
    }
}

/// The largest sum of one sign while the blow lasts. Almost all of both waves cannot be part of it: from
/// whole pieces to halves of halves of them, what cannot come to the largest sum that was seen so far with
/// anything that it meets is left out. What is left is looked at in every part.
class LargestMeeting {
  public:
    LargestMeeting(const Impact& impact, double sign)
        : m_impact(impact), m_sign(sign), m_end(recordedEndOfBlow(impact)) {}

    /// `pieces` are whole, `ends` those of them.
    Meeting find(const std::vector<WaveSpan>& pieces, const std::vector<Instant>& ends) {
        std::vector<WaveSpan> spans = kept(pieces, sumsOf(ends).size);
        while (!std::ranges::all_of(spans, &WaveSpan::isOnePart)) {
            halve(m_impact, spans);
            spans = kept(spans, sumsOf(endsOf(spans)).size);
        }
        return sumsOf(instantsOf(spans));
    }
    /// Spans so far.
    long looked() const { return m_looked; }

  private:
    /// Of instants in order of time, all of which are instants of the blow.
    Meeting sumsOf(const std::vector<Instant>& instants) const {
        Meeting most;
        SlidingMaximum sliding(m_sign, m_impact.roundTrip, most);
        sliding.pass(instantBeforeFront(m_impact, 0));
        for (const Instant& now : instants)
            if (now.time <= m_end) sliding.pass(now);
        addLastMeetings(instants, m_end, m_impact.roundTrip, m_sign, most);
        return most;
    }

    /// With the counterparts of what meets them at the end of the blow.
    std::vector<Instant> instantsOf(const std::vector<WaveSpan>& spans) const {
        const double half = m_impact.roundTrip / 2;
        std::vector<Instant> instants;
        const WaveSpan* before = nullptr;
        for (const WaveSpan& span : spans) {
            if (!before || before->piece != span.piece || before->last != span.first)
                instants.push_back(span.begin);
            before = &span;
            if (span.end.time >= m_end - half && span.begin.time <= m_end + half)
                addCounterparts(span, instants);
            instants.push_back(span.end);
        }
        return instants;
    }

    void addCounterparts(const WaveSpan& span, std::vector<Instant>& instants) const {
        const double start = m_impact.incident.pieces()[span.piece].start;
        const double from = endOfPart(m_impact, span.piece, span.first, span.bends.parts);
        const double until = endOfPart(m_impact, span.piece, span.last, span.bends.parts);
        for (const double time : counterparts(m_impact, m_end, span.begin.time, span.end.time)) {
            const double x = time - start;
            if (time > start && x >= from && x < until)
                instants.push_back(instantIn(m_impact, span.piece, x, Side::inside));
        }
    }

    /// Without what cannot be part of a sum of `least` or more: neither as the incoming wave, with the
    /// largest of what that meets, nor as the reflected one.
    std::vector<WaveSpan> kept(const std::vector<WaveSpan>& spans, double least) {
        m_looked += static_cast<long>(spans.size());
        const auto suffices = [least](double sum) { return sum > 0 && sum >= least; };
        // what was in the rod before the first front
        const double atFirst = m_sign * instantBeforeFront(m_impact, 0).reflected;

        // at first with the largest of all, wherever that is: what is left out here meets nothing else
        std::vector<SpanBound> bounds;
        bounds.reserve(spans.size());
        SpanBound most{-std::numeric_limits<double>::infinity(), atFirst};
        for (const WaveSpan& span : spans) {
            const SpanBound& bound = bounds.emplace_back(boundOf(span, m_sign));
            most = {std::max(most.incident, bound.incident), std::max(most.reflected, bound.reflected)};
        }
        std::vector<const WaveSpan*> some;
        std::vector<double> incident, reflected;
        for (std::size_t i = 0; i < spans.size(); ++i) {
            if (!suffices(bounds[i].incident + most.reflected) &&
                !suffices(bounds[i].reflected + most.incident))
                continue;
            some.push_back(&spans[i]);
            incident.push_back(bounds[i].incident);
            reflected.push_back(bounds[i].reflected);
        }

        // then with the largest of what it meets
        const RangeMaximum mostIncident(incident), mostReflected(reflected);
        std::vector<WaveSpan> left;
        for (std::size_t i = 0; i < some.size(); ++i) {
            const double oldest = some[i]->begin.time - m_impact.roundTrip - rounding(*some[i]);
            const double met = mostReflected.over(firstEndingAt(some, oldest), behindMet(some, i));
            if (suffices(incident[i] + (oldest <= 0 ? std::max(met, atFirst) : met)) ||
                suffices(reflected[i] +
                         mostIncident.over(i, firstBeginningAfter(some, lastToMeet(*some[i])))))
                left.push_back(*some[i]);
        }
        return left;
    }

    using Spans = std::vector<const WaveSpan*>;
    double rounding(const WaveSpan& span) const {
        return 2 * roundingOfTrip(std::max(span.end.time, m_end), m_impact.roundTrip);
    }
    static std::size_t firstEndingAt(const Spans& spans, double time) {
        const auto found = std::ranges::partition_point(
            spans, [time](const WaveSpan* span) { return span->end.time < time; });
        return static_cast<std::size_t>(found - spans.begin());
    }
    static std::size_t firstBeginningAfter(const Spans& spans, double time) {
        const auto found = std::ranges::partition_point(
            spans, [time](const WaveSpan* span) { return span->begin.time <= time; });
        return static_cast<std::size_t>(found - spans.begin());
    }
    /// Behind the last span of which span number i may meet anything.
    std::size_t behindMet(const Spans& spans, std::size_t i) const {
        if (spans[i]->begin.time <= m_end) return i + 1;
        const double last = 2 * m_end - spans[i]->begin.time + rounding(*spans[i]);
        return std::min(i + 1, firstBeginningAfter(spans, last));
    }
    /// Until when something comes in that meets some of this span.
    double lastToMeet(const WaveSpan& span) const {
        const double last = span.end.time + m_impact.roundTrip + rounding(span);
        if (last <= m_end) return last;
        return std::max(m_end, std::min(last, 2 * m_end - span.begin.time + rounding(span)));
    }

    const Impact& m_impact;
    double m_sign;
    double m_end;
    long m_looked = 0;
};

/// The first instant of the last period, whose pieces these are, at which the incident wave, times `sign`, is
/// largest.
Instant largestOfLastPeriod(const Impact& impact, double sign, std::vector<WaveSpan> spans) {
    const double from = impact.incident.end() - impact.roundTrip;
    Instant most{};
    double size = -std::numeric_limits<double>::infinity();
    const auto offer = [&](const Instant& now) {
        if (now.time >= from && sign * now.incident > size) most = now, size = sign * now.incident;
    };
    for (;; halve(impact, spans)) {
        for (const WaveSpan& span : spans) offer(span.begin), offer(span.end);
        std::erase_if(spans, [&](const WaveSpan& each) { return boundOf(each, sign).incident < size; });
        if (std::ranges::all_of(spans, &WaveSpan::isOnePart)) break;
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
        const std::vector<Instant> ends = endsOf(pieces);
        const auto find = [&](double sign) {
            LargestMeeting search(impact, sign);
            const RodForce found = search.find(pieces, ends).found(impact);
            if (looked) *looked += search.looked();
            return found;
        };
        if (choice.compression) forces.compression = find(1);
        if (choice.tension) forces.tension = find(-1);
    }
    if (choice.compression && pulse.peak > forces.compression.size) forces.compression = hammerPeak(pulse);
    return forces;
}

}  // namespace drillwave
