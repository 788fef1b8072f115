// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/section_watch.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

/// How many blocks of cells a pair of cells is worth that is looked at closely.
constexpr long blocksOfPair = 6;

}  // namespace

struct SectionWatch::Meeting {
    const WaveCell& down;
    const WaveCell& up;
    std::span<const WaveCell> window;
    long step;
    const CellCuts& cuts;
    double lastTime;

    long oldest() const { return step - static_cast<long>(window.size()); }
};

void SectionWatch::push(Side& side, const WaveCell& cell, long step, const CellCuts& cuts) const {
    const WaveCell::Peak peak = (side.sign * cell).peak();
    if (m_section.decay > 0) side.maxima.push(step, peak.value);
    while (!side.largest.empty() && side.largest.back().value <= peak.value) side.largest.pop_back();
    side.largest.push_back({step, cuts.clock(step) + peak.place * cuts.width(step), peak.value});
}

void SectionWatch::note(SectionPeak& peak, double force, double downClock, double upClock,
                        double lastTime) const {
    if (force <= peak.force) return;
    // f left the rear end at s, b the front end at q: they meet after (q − s + T)/2 of the way
    const double s = m_section.startTime + downClock;
    const double q = m_section.startTime + m_section.transitTime + upClock;
    const double time = (s + q + m_section.transitTime) / 2;
    if (time > lastTime) return;
    const double place = (q - s + m_section.transitTime) / (2 * m_section.transitTime);
    constexpr double atEnd = 1e-9;  // an end, but for rounding
    peak = {force, place < atEnd ? 0 : place > 1 - atEnd ? 1 : place, time};
}

void SectionWatch::watch(Side& side, const Meeting& meeting) const {
    const WaveCell f = side.sign * meeting.down;
    const WaveCell::Peak top = f.peak();
    const double clock = meeting.cuts.clock(meeting.step), width = meeting.cuts.width(meeting.step);
    const auto at = [&](double place) { return clock + place * width; };
    const auto tell = [&](double force, double downClock, double upClock) {
        note(side.peak, force, downClock, upClock, meeting.lastTime);
    };
    if (!side.largest.empty())
        tell(top.value + side.largest.front().value, at(top.place), side.largest.front().clock);

    // of the cell of a round trip ago f meets only what left later in it, of the present one what left
    // earlier
    const auto pair = [&](const WaveCell& b, double shift, bool later) {
        const WaveCell::Peak other = b.peak();
        if (top.value + other.value <= side.peak.force) return;
        const auto candidate = [&](double force, double u, double v) { tell(force, at(u), at(v) - shift); };
        if (later ? other.place >= top.place : other.place <= top.place)
            candidate(top.value + other.value, top.place, other.place);
        const double first = later ? 0 : 1;
        candidate(f.value(first) + other.value, first, other.place);
        candidate(top.value + b.value(1 - first), top.place, 1 - first);
        const WaveCell::Peak sum = (f + b).peak();
        candidate(sum.value, sum.place, sum.place);
    };
    pair(side.sign * meeting.window.front(), 2 * m_section.transitTime, true);
    pair(side.sign * meeting.up, 0, false);
}

/// The most that waves of these values at their ends come to where they meet: `share` is how much of its way
/// b has gone by then, between two limits. The sum is a convex function of it.
double SectionWatch::mostOf(double down, double up, double earliestShare, double latestShare) const {
    const double f = std::max(down, 0.0), b = std::max(up, 0.0);
    const auto sum = [&](double share) {
        const double way = std::clamp(share, 0.0, 1.0);
        return f * std::exp(-m_section.decay * (1 - way)) + b * std::exp(-m_section.decay * way);
    };
    return std::max(sum(earliestShare), sum(latestShare));
}

/// Where waves lose on their way it matters where they meet: all that may come into question is tried, with
/// each cell's ends and its top.
void SectionWatch::watchDecaying(Side& side, const Meeting& meeting) {
    const WaveCell f = side.sign * meeting.down;
    const WaveCell::Peak top = f.peak();
    const double most = side.largest.empty() ? 0 : side.largest.front().value;
    const double edge =
        std::max((side.sign * meeting.window.front()).peak().value, (side.sign * meeting.up).peak().value);
    if (top.value + std::max(most, edge) <= side.peak.force) return;
    const CellCuts& cuts = meeting.cuts;
    const double clock = cuts.clock(meeting.step), end = clock + cuts.width(meeting.step);
    const double roundTrip = 2 * m_section.transitTime;
    meet(side, meeting, f, 0);
    meet(side, meeting, f, meeting.window.size());
    const auto mayHold = [&](double largest, long first, long behind) {
        const double from = cuts.clock(first), to = cuts.clock(behind);
        const double earliest = m_section.startTime + (clock + from) / 2 + m_section.transitTime;
        if (earliest > meeting.lastTime || top.value + largest <= side.peak.force) return false;
        return mostOf(top.value, largest, (clock - to) / roundTrip, (end - from) / roundTrip) >
               side.peak.force;
    };
    m_looked += side.maxima.search(meeting.oldest() + 1, meeting.step, mayHold, [&](long step) {
        m_looked += blocksOfPair;
        meet(side, meeting, f, static_cast<std::size_t>(step - meeting.oldest()));
    });
}

/// f with cell number `number` of the window; the one behind the last is the present one.
void SectionWatch::meet(Side& side, const Meeting& meeting, const WaveCell& f, std::size_t number) const {
    const bool present = number == meeting.window.size(), oldest = number == 0;
    const WaveCell b = side.sign * (present ? meeting.up : meeting.window[number]);
    const WaveCell::Peak top = f.peak(), other = b.peak();
    if (top.value + other.value <= side.peak.force) return;
    const double clock = meeting.cuts.clock(meeting.step), width = meeting.cuts.width(meeting.step);
    const double roundTrip = 2 * m_section.transitTime;
    const long step = meeting.oldest() + static_cast<long>(number);
    const double upStart = present ? clock : oldest ? clock - roundTrip : meeting.cuts.clock(step);
    const double upWidth = present || oldest ? width : meeting.cuts.width(step);
    if (mostOf(top.value, other.value, (clock - upStart - upWidth) / roundTrip,
               (clock + width - upStart) / roundTrip) <= side.peak.force)
        return;
    for (const double u : {0.0, top.place, 1.0})
        for (const double v : {0.0, other.place, 1.0}) {
            if ((present && v > u) || (oldest && v < u)) continue;
            const double downClock = clock + u * width, upClock = upStart + v * upWidth;
            const double share = (downClock - upClock) / roundTrip;  // of its way that b has gone
            const double force = f.value(u) * std::exp(-m_section.decay * (1 - share)) +
                                 b.value(v) * std::exp(-m_section.decay * share);
            note(side.peak, force, downClock, upClock, meeting.lastTime);
        }
}

void SectionWatch::add(const WaveCell& down, const WaveCell& up, std::span<const WaveCell> window, long step,
                       const CellCuts& cuts, double lastTime) {
    const Meeting meeting{down, up, window, step, cuts, lastTime};
    for (Side* side : {&m_compression, &m_tension}) {
        while (!side->largest.empty() && side->largest.front().step <= meeting.oldest())
            side->largest.pop_front();
        side->maxima.dropBefore(meeting.oldest());
        m_section.decay > 0 ? watchDecaying(*side, meeting) : watch(*side, meeting);
        push(*side, up, step, cuts);
    }
}

void SectionWatch::restart(std::span<const WaveCell> window, long step, const CellCuts& cuts) {
    for (Side* side : {&m_compression, &m_tension}) {
        side->largest.clear();
        side->maxima.clear();
        long at = step - static_cast<long>(window.size());
        for (const WaveCell& cell : window) push(*side, cell, at++, cuts);
    }
}

}  // namespace drillwave
