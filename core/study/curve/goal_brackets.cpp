// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/goal_brackets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/numeric/fit_features.h"

namespace drillwave {

namespace {

using Segments = std::span<const MonotoneSegment>;

constexpr double lastDigitsOfGoal = 4 * std::numeric_limits<double>::epsilon();

/// Returns whether a piece is a straight line between two known points.
bool isBetweenPoints(const FitPiece& piece) {
    return !piece.resolved && piece.end - piece.start > leastSlopeWidth;
}

/// Returns the error at the ends of a segment; the error of a line between points also includes its rise.
double marginOf(const MonotoneSegment& segment, double goal) {
    const double rise = isBetweenPoints(*segment.piece) ? std::abs(segment.last - segment.first) : 0;
    return std::max(0.0, segment.error() - rise) + lastDigitsOfGoal * std::abs(goal);
}

int sideOf(double value, double goal, double margin) {
    return value > goal + margin ? 1 : value < goal - margin ? -1 : 0;
}

/// Goes along a curve and notes where it is at the goal.
class Walk {
  public:
    explicit Walk(double goal) : m_goal(goal) {}

    void add(const MonotoneSegment& segment) {
        m_margin = marginOf(segment, m_goal);
        const int first = sideOf(segment.first, m_goal, m_margin);
        const int last = sideOf(segment.last, m_goal, m_margin);
        const bool goesOn = m_before && segment.start - m_before->end <= leastSlopeWidth;
        if (!goesOn) end();
        meet(segment, first, goesOn);
        follow(segment, first, last);
        m_side = last;
        m_before = &segment;
    }

    /// The curve ends, or there is no answer behind.
    void end() {
        if (m_open) close(m_before->end, m_before->end, m_before->last, 0);
        m_side = 0;
    }

    std::vector<GoalBracket> take() { return std::move(m_found); }

  private:
    /// Where a segment begins.
    void meet(const MonotoneSegment& segment, int first, bool goesOn) {
        if (m_open && first != 0) return close(segment.start, segment.start, segment.first, first);
        if (m_open) return;
        if (goesOn && m_side * first < 0) {
            open(m_before->end, m_before->end, m_before->last, m_side);
            close(segment.start, segment.start, segment.first, first);
        } else if (first == 0) {
            const MonotoneSegment& from = goesOn ? *m_before : segment;
            open(segment.start, from.start, from.first, goesOn ? m_side : 0);
        }
    }

    void follow(const MonotoneSegment& segment, int first, int last) {
        const auto placeOn = [&](int side) {
            return segment.placeOf(std::clamp(m_goal + side * m_margin, segment.lower(), segment.upper()));
        };
        if (m_open) m_open->margin = std::max(m_open->margin, m_margin);
        if (first == last) return;
        if (first != 0) open(placeOn(first), segment.start, segment.first, first);
        m_open->isOpen = first * last < 0 && isBetweenPoints(*segment.piece);
        if (last != 0) close(placeOn(last), segment.end, segment.last, last);
    }

    void open(double at, double from, double valueFrom, int before) {
        GoalBracket& opened = m_open.emplace();
        opened.from = from;
        opened.valueFrom = valueFrom;
        opened.before = before;
        opened.margin = m_margin;
        m_begin = at;
    }

    void close(double at, double to, double valueTo, int after) {
        GoalBracket& found = *m_open;
        found.to = to;
        found.valueTo = valueTo;
        found.after = after;
        const double width = at - m_begin;
        if ((found.before == 0) == (after == 0))
            found.share = {m_begin / 2 + at / 2, width / 2};
        else
            found.share = {found.before == 0 ? m_begin : at, width};
        found.share.error += lastDigitsOfGoal;
        m_found.push_back(found);
        m_open.reset();
    }

    double m_goal;
    double m_margin = 0;
    int m_side = 0;
    double m_begin = 0;  // of what is open
    const MonotoneSegment* m_before = nullptr;
    std::optional<GoalBracket> m_open;
    std::vector<GoalBracket> m_found;
};

}  // namespace

std::vector<GoalBracket> goalBrackets(Segments segments, double goal) {
    Walk walk(goal);
    for (const MonotoneSegment& segment : segments) walk.add(segment);
    walk.end();
    return walk.take();
}

NearestValue nearestTo(Segments segments, double goal) {
    assert(!segments.empty());
    const FitExtreme least = extremeOf(segments, Extreme::least);
    const FitExtreme largest = extremeOf(segments, Extreme::largest);
    if (goal <= least.value.value) return {least.place, least.value};
    if (goal >= largest.value.value) return {largest.place, largest.value};
    // Passed in a jump, or where there is no answer: one of the ends beside it.
    NearestValue nearest{least.place, least.value};
    for (const MonotoneSegment& segment : segments)
        for (const bool atStart : {true, false}) {
            const double value = atStart ? segment.first : segment.last;
            if (std::abs(value - goal) < std::abs(nearest.value.value - goal))
                nearest = {{atStart ? segment.start : segment.end, 0}, {value, segment.error()}};
        }
    return nearest;
}

}  // namespace drillwave
