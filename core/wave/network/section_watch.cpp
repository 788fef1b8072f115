// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/section_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

/// How many blocks of cells a pair of cells is worth that is looked at closely.
constexpr long blocksOfPair = 6;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Upper bounds of pushing and pulling in cells.
struct CellBounds {
    double push = -std::numeric_limits<double>::infinity();
    double pull = push;

    double of(double sign) const { return sign > 0 ? push : pull; }
};

/// Returns bounds never below WaveCell::peak() of any of the cells, nor below their values: Legendre
/// polynomials are at most 1. The sums in both lose a few units of the last place of the coefficients by
/// rounding, and nothing for cells that are one constant, of which there are many; this rounding is added
/// here.
CellBounds boundsOf(std::span<const WaveCell> cells) {
    constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();
    CellBounds even, odd;  // independent of each other
    const auto add = [](CellBounds& bounds, const WaveCell& cell) {
        const double spread = cell.spread();
        bounds.push = std::max(bounds.push, spread + cell.c[0]);
        bounds.pull = std::max(bounds.pull, spread - cell.c[0]);
    };
    std::size_t i = 0;
    for (; i + 1 < cells.size(); i += 2) {
        add(even, cells[i]);
        add(odd, cells[i + 1]);
    }
    if (i < cells.size()) add(even, cells[i]);
    CellBounds bounds{std::max(even.push, odd.push), std::max(even.pull, odd.pull)};
    // twice the largest spread at least, and 0 for one constant
    if (bounds.push + bounds.pull > 0) {
        const double margin = rounding * (std::abs(bounds.push) + std::abs(bounds.pull));
        bounds.push += margin;
        bounds.pull += margin;
    }
    return bounds;
}

double mostOfCell(const WaveCell& cell, double sign) {
    return boundsOf({&cell, 1}).of(sign);
}

/// Calls `use(first, count)` for the parts of `count` steps from `step` on that lie in one block each.
template <class Use>
void forEachBlock(long step, std::size_t count, Use use) {
    for (std::size_t first = 0; first < count;) {
        const long from = step + static_cast<long>(first);
        const long left = WindowMaxima::blockStart(from) + WindowMaxima::smallest - from;
        const std::size_t part = std::min(count - first, static_cast<std::size_t>(left));
        use(first, part);
        first += part;
    }
}

}  // namespace

void WindowMaxima::begin(long window) {
    m_levels.clear();
    for (long size = smallest;; size *= growth) {
        m_levels.push_back({.size = size, .first = 0, .largest = {}});
        if (size >= window) return;  // a block of the largest size holds a window, or two do
    }
}

void WindowMaxima::push(long step, double value) {
    for (Level& level : m_levels) {
        const long block = blockOf(step, level.size);
        if (level.largest.empty()) level.first = block;
        if (level.first + static_cast<long>(level.largest.size()) <= block)
            level.largest.push_back(value);
        else
            level.largest.back() = std::max(level.largest.back(), value);
    }
}

void WindowMaxima::dropBefore(long oldest) {
    for (Level& level : m_levels)
        while (!level.largest.empty() && (level.first + 1) * level.size <= oldest) {
            level.largest.pop_front();
            ++level.first;
        }
}

struct SectionWatch::Meeting {
    const WaveCell& down;
    const WaveCell& up;
    std::span<const WaveCell> window;  ///< entered before, over a round trip, the oldest first
    long step;
    const CellCuts& cuts;
    double mostUp;  ///< no cell of the window, nor `up`, is more

    long oldest() const { return step - static_cast<long>(window.size()); }
    const WaveCell& cell(long ofStep) const { return window[static_cast<std::size_t>(ofStep - oldest())]; }
};

void SectionWatch::note(const Span& span, double force, double downClock, double upClock) const {
    if (force <= span.peak.force) return;
    // f left the rear end at s, b the front end at q: they meet after (q − s + T)/2 of the way
    const double s = m_section.startTime + downClock;
    const double q = m_section.startTime + m_section.transitTime + upClock;
    const double time = (s + q + m_section.transitTime) / 2;
    if (time <= span.after || time > span.until) return;
    const double place = (q - s + m_section.transitTime) / (2 * m_section.transitTime);
    constexpr double atEnd = 1e-9;  // an end, but for rounding
    span.peak = {force, place < atEnd ? 0 : place > 1 - atEnd ? 1 : place, time};
}

void SectionWatch::watch(const Span& span, const Side& side, const Meeting& meeting) {
    if (mostOfCell(meeting.down, side.sign) + meeting.mostUp <= span.peak.force) return;
    ++m_cells;
    const WaveCell f = side.sign * meeting.down;
    const WaveCell::Peak top = f.peak();
    if (top.value + meeting.mostUp <= span.peak.force) return;
    m_section.decay > 0 || span.hasEdge ? watchClosely(span, side, meeting, f, top)
                                        : watchAnywhere(span, side, meeting, f, top);
}

/// Where waves keep their size, and all that meets now is within the span, the sum alone counts.
void SectionWatch::watchAnywhere(const Span& span, const Side& side, const Meeting& meeting,
                                 const WaveCell& f, const WaveCell::Peak& top) {
    const double clock = meeting.cuts.clock(meeting.step), width = meeting.cuts.width(meeting.step);
    const auto at = [&](double place) { return clock + place * width; };
    const auto tell = [&](double force, double downClock, double upClock) {
        note(span, force, downClock, upClock);
    };

    // the largest value on its way, the latest of several: any other makes no larger force
    WaveCell::Peak most{0, -infinity};
    long ofMost = 0;
    const auto mayHold = [&](double largest) {
        return largest > most.value && top.value + largest > span.peak.force;
    };
    side.maxima.search(
        meeting.oldest() + 1, meeting.step, [&](double largest, long, long) { return mayHold(largest); },
        [&](long step) {
            const WaveCell& cell = meeting.cell(step);
            if (!mayHold(mostOfCell(cell, side.sign))) return;
            const WaveCell::Peak peak = (side.sign * cell).peak();
            if (peak.value > most.value) most = peak, ofMost = step;
        });
    if (top.value + most.value > span.peak.force)
        tell(top.value + most.value, at(top.place),
             meeting.cuts.clock(ofMost) + most.place * meeting.cuts.width(ofMost));

    // of the cell of a round trip ago f meets only what left later in it, of the present one what left
    // earlier
    const auto pair = [&](const WaveCell& up, double shift, bool later) {
        if (top.value + mostOfCell(up, side.sign) <= span.peak.force) return;
        const WaveCell b = side.sign * up;
        const WaveCell::Peak other = b.peak();
        if (top.value + other.value <= span.peak.force) return;
        const auto candidate = [&](double force, double u, double v) { tell(force, at(u), at(v) - shift); };
        if (later ? other.place >= top.place : other.place <= top.place)
            candidate(top.value + other.value, top.place, other.place);
        const double first = later ? 0 : 1;
        candidate(f.value(first) + other.value, first, other.place);
        candidate(top.value + b.value(1 - first), top.place, 1 - first);
        const WaveCell::Peak sum = (f + b).peak();
        candidate(sum.value, sum.place, sum.place);
    };
    pair(meeting.window.front(), 2 * m_section.transitTime, true);
    pair(meeting.up, 0, false);
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

/// Where waves lose on their way it matters where they meet, and when where the span begins or ends
/// meanwhile: all that may come into question is tried, with each cell's ends and its top.
void SectionWatch::watchClosely(const Span& span, const Side& side, const Meeting& meeting, const WaveCell& f,
                                const WaveCell::Peak& top) {
    const CellCuts& cuts = meeting.cuts;
    const double clock = cuts.clock(meeting.step), end = clock + cuts.width(meeting.step);
    const double roundTrip = 2 * m_section.transitTime;
    meet(span, side.sign, meeting, f, top, 0);
    meet(span, side.sign, meeting, f, top, meeting.window.size());
    const auto mayHold = [&](double largest, long first, long behind) {
        const double from = cuts.clock(first), to = cuts.clock(behind);
        const double earliest = m_section.startTime + (clock + from) / 2 + m_section.transitTime;
        const double latest = m_section.startTime + (end + to) / 2 + m_section.transitTime;
        if (earliest > span.until || latest <= span.after) return false;
        if (top.value + largest <= span.peak.force) return false;
        return mostOf(top.value, largest, (clock - to) / roundTrip, (end - from) / roundTrip) >
               span.peak.force;
    };
    m_looked += side.maxima.search(meeting.oldest() + 1, meeting.step, mayHold, [&](long step) {
        if (top.value + mostOfCell(meeting.cell(step), side.sign) <= span.peak.force) return;
        m_looked += blocksOfPair;
        meet(span, side.sign, meeting, f, top, static_cast<std::size_t>(step - meeting.oldest()));
    });
}

/// f with cell number `number` of the window; the one behind the last is the present one.
void SectionWatch::meet(const Span& span, double sign, const Meeting& meeting, const WaveCell& f,
                        const WaveCell::Peak& top, std::size_t number) const {
    const bool present = number == meeting.window.size(), oldest = number == 0;
    const WaveCell b = sign * (present ? meeting.up : meeting.window[number]);
    const WaveCell::Peak other = b.peak();
    if (top.value + other.value <= span.peak.force) return;
    const double clock = meeting.cuts.clock(meeting.step), width = meeting.cuts.width(meeting.step);
    const double roundTrip = 2 * m_section.transitTime;
    const long step = meeting.oldest() + static_cast<long>(number);
    const double upStart = present ? clock : oldest ? clock - roundTrip : meeting.cuts.clock(step);
    const double upWidth = present || oldest ? width : meeting.cuts.width(step);
    if (mostOf(top.value, other.value, (clock - upStart - upWidth) / roundTrip,
               (clock + width - upStart) / roundTrip) <= span.peak.force)
        return;
    for (const double u : {0.0, top.place, 1.0})
        for (const double v : {0.0, other.place, 1.0}) {
            if ((present && v > u) || (oldest && v < u)) continue;
            const double downClock = clock + u * width, upClock = upStart + v * upWidth;
            const double share = (downClock - upClock) / roundTrip;  // of its way that b has gone
            const double force = f.value(u) * std::exp(-m_section.decay * (1 - share)) +
                                 b.value(v) * std::exp(-m_section.decay * share);
            note(span, force, downClock, upClock);
        }
}

/// Returns the upper bound of the cells on their way from step `first` to before
/// `behind`; less only if none of them exceeds `known` with a wave of at most
/// `down`.
double SectionWatch::mostOnTheWay(const Side& side, double down, double known, long first, long behind) {
    double most = -infinity;
    side.maxima.search(
        first, behind,
        [&](double largest, long from, long to) {
            if (largest <= most || down + largest <= known) return false;
            if (to - from > WindowMaxima::smallest) return true;  // its parts may be less
            most = largest;
            return false;
        },
        [](long) {});
    return most;
}

void SectionWatch::setEndOfBlow(double time, double lastAfter) {
    if (time == m_endOfBlow) return;
    m_endOfBlow = time;
    m_lastAfter = std::max(time, lastAfter);
    for (Side* side : {&m_compression, &m_tension}) {
        for (SectionPeak* peak : {&side->after, &side->later}) {
            if (peak->force > side->during.force) side->during = *peak;
            *peak = {};
        }
    }
}

/// Returns the span of one part of the time for what meets from `first` to `last`.
SectionWatch::Span SectionWatch::spanOf(Side& side, Part part, double lastTime, double first,
                                        double last) const {
    const double from = part == Part::during ? -infinity : part == Part::after ? m_endOfBlow : m_lastAfter;
    const double end = part == Part::during ? m_endOfBlow : part == Part::after ? m_lastAfter : infinity;
    const double until = std::min(end, lastTime);
    // Only more than all before counts later, which leaves hardly any cell to be looked into.
    if (part == Part::later)
        for (const SectionPeak& before : {side.during, side.after})
            if (before.force > side.later.force) side.later = before;
    SectionPeak& peak = part == Part::during ? side.during : part == Part::after ? side.after : side.later;
    return {peak, from, until, first <= from || last > until};
}

void SectionWatch::add(std::span<const WaveCell> downs, std::span<const WaveCell> ups, long step,
                       const CellCuts& cuts, double lastTime) {
    const std::size_t window = ups.size() - downs.size();
    forEachBlock(step, downs.size(), [&](std::size_t begin, std::size_t count) {
        const long from = step + static_cast<long>(begin), behind = from + static_cast<long>(count);
        const long oldest = from - static_cast<long>(window);
        // the first waves of the block meet here at once, the last after one transit
        const double first = m_section.startTime + cuts.clock(from);
        const double last = m_section.startTime + cuts.clock(behind) + m_section.transitTime;
        const CellBounds down = boundsOf(downs.subspan(begin, count));
        push(ups.subspan(window + begin, count), from);
        for (Side* side : {&m_compression, &m_tension}) {
            side->maxima.dropBefore(oldest);
            for (const Part part : {Part::during, Part::after, Part::later}) {
                const Span span = spanOf(*side, part, lastTime, first, last);
                if (last <= span.after || first > span.until) continue;
                const double mostDown = down.of(side->sign);
                const double mostUp = mostOnTheWay(*side, mostDown, span.peak.force, oldest, behind);
                if (mostDown + mostUp <= span.peak.force) continue;
                for (std::size_t i = begin; i < begin + count; ++i)
                    watch(span, *side,
                          {downs[i], ups[window + i], ups.subspan(i, window), step + static_cast<long>(i),
                           cuts, mostUp});
            }
        }
    });
}

/// Pushes upper bounds of the cells from `step` on.
void SectionWatch::push(std::span<const WaveCell> cells, long step) {
    const CellBounds bounds = boundsOf(cells);
    m_compression.maxima.push(step, bounds.push);
    m_tension.maxima.push(step, bounds.pull);
}

void SectionWatch::restart(std::span<const WaveCell> window, long step) {
    const long oldest = step - static_cast<long>(window.size());
    for (Side* side : {&m_compression, &m_tension}) side->maxima.begin(static_cast<long>(window.size()) + 1);
    forEachBlock(oldest, window.size(), [&](std::size_t first, std::size_t count) {
        push(window.subspan(first, count), oldest + static_cast<long>(first));
    });
}

}  // namespace drillwave
