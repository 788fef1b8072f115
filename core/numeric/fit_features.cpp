// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/fit_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/numeric/brent.h"

namespace drillwave {

namespace {

using Segments = std::span<const MonotoneSegment>;

constexpr double roundingOfValues = 4 * std::numeric_limits<double>::epsilon();

FitSide sideOf(const FitPiece& piece, std::size_t output, double x) {
    // Markov's inequality for polynomials of degree 16 that are off by the error.
    const double error = 512 * piece.error[output] / (piece.end - piece.start);
    return {&piece, piece.outputs[output].slope(x), error};
}

/// How far from `place`, an end of segment `i`, the value stays within `margin`, to the right or to the left.
double stay(Segments segments, std::ptrdiff_t i, int direction, double place, double value, double margin) {
    double reached = place;
    for (; i >= 0 && i < std::ssize(segments); i += direction) {
        const MonotoneSegment& segment = segments[static_cast<std::size_t>(i)];
        const double outer = direction > 0 ? segment.last : segment.first;
        if (std::abs(outer - value) > margin) {
            const double level =
                std::clamp(outer > value ? value + margin : value - margin, segment.lower(), segment.upper());
            return std::abs(segment.placeOf(level) - place);
        }
        reached = direction > 0 ? segment.end : segment.start;
    }
    return std::abs(reached - place);
}

/// An end of a segment, known with an error, as a place whose error is how far the value stays within that.
Estimate placeOfEnd(Segments segments, std::size_t where, bool atStart, const Estimate& value) {
    const double place = atStart ? segments[where].start : segments[where].end;
    const auto i = static_cast<std::ptrdiff_t>(where);
    const double left = stay(segments, atStart ? i - 1 : i, -1, place, value.value, 2 * value.error);
    const double right = stay(segments, atStart ? i : i + 1, 1, place, value.value, 2 * value.error);
    return {place, std::max(left, right)};
}

}  // namespace

double MonotoneSegment::placeOf(double wanted) const {
    assert(wanted >= lower() && wanted <= upper());
    if (wanted == first) return start;
    if (wanted == last) return end;
    return brentRoot([&](double x) { return value(x) - wanted; }, start, first - wanted, end, last - wanted);
}

std::vector<MonotoneSegment> segmentsOf(std::span<const FitPiece> pieces, std::size_t output) {
    std::vector<MonotoneSegment> segments;
    for (const FitPiece& piece : pieces) {
        if (!piece.solved) continue;
        const Chebyshev& function = piece.outputs[output];
        std::vector<double> cuts = function.stationaryPoints();
        cuts.push_back(piece.end);
        double from = piece.start;
        for (const double cut : cuts) {
            if (cut <= from) continue;
            segments.push_back({from, cut, function(from), function(cut), &piece, output});
            from = cut;
        }
    }
    return segments;
}

bool hasSlope(const FitPiece& piece) {
    return piece.resolved && piece.end - piece.start > leastSlopeWidth;
}

std::optional<std::pair<FitSide, FitSide>> sidesAt(std::span<const FitPiece> pieces, std::size_t output,
                                                   double fromLeft, double fromRight) {
    const FitPiece* before = nullptr;
    const FitPiece* after = nullptr;
    for (const FitPiece& piece : pieces) {
        if (!hasSlope(piece)) continue;
        if (piece.start < fromRight && piece.end > fromRight) return std::nullopt;
        if (piece.end <= fromLeft) before = &piece;
        if (piece.start >= fromRight && !after) after = &piece;
    }
    if (!before || !after) return std::nullopt;
    return std::pair{sideOf(*before, output, before->end), sideOf(*after, output, after->start)};
}

bool isAngle(const FitSide& left, const FitSide& right, double scale) {
    const double steeper = std::max({scale, std::abs(left.slope), std::abs(right.slope)});
    return std::abs(right.slope - left.slope) > leastAngle * steeper + left.error + right.error;
}

FitExtreme extremeOf(Segments segments, Extreme which) {
    assert(!segments.empty());
    const double sign = which == Extreme::largest ? 1 : -1;
    std::size_t where = 0;
    bool atStart = true;
    double opposite = std::numeric_limits<double>::infinity(), best = -opposite, bound = -opposite;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (const bool start : {true, false}) {
            const double value = sign * (start ? segments[i].first : segments[i].last);
            bound = std::max(bound, value + segments[i].error());
            opposite = std::min(opposite, value);
            if (value <= best) continue;
            best = value;
            where = i;
            atStart = start;
        }
    const Estimate value{sign * best, bound - best + roundingOfValues * std::abs(best)};
    return {.value = value,
            .place = placeOfEnd(segments, where, atStart, value),
            .everywhere = best - opposite <= 2 * value.error};
}

std::vector<LocalExtreme> localExtremesOf(Segments segments) {
    std::vector<LocalExtreme> extremes;
    if (segments.empty()) return extremes;
    // The largest and the least value since the last extreme: one of them is the next, once the function has
    // come back from it by more than errors.
    struct Candidate {
        std::size_t segment;
        bool atStart;
        double value;
        double error;
    };
    const auto errorOf = [](const MonotoneSegment& segment, double value) {
        return segment.error() + roundingOfValues * std::abs(value);
    };
    Candidate high{0, true, segments[0].first, errorOf(segments[0], segments[0].first)}, low = high;
    enum class Direction { unknown, up, down } direction = Direction::unknown;
    const auto note = [&](Extreme which, const Candidate& candidate) {
        const Estimate value{candidate.value, candidate.error};
        extremes.push_back({which, value, placeOfEnd(segments, candidate.segment, candidate.atStart, value)});
    };
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (const bool atStart : {true, false}) {
            const double value = atStart ? segments[i].first : segments[i].last;
            const Candidate here{i, atStart, value, errorOf(segments[i], value)};
            if (value > high.value) high = here;
            if (value < low.value) low = here;
            if (direction != Direction::down && high.value - value > 2 * (high.error + here.error)) {
                if (direction == Direction::up) note(Extreme::largest, high);
                direction = Direction::down;
                low = here;
            } else if (direction != Direction::up && value - low.value > 2 * (low.error + here.error)) {
                if (direction == Direction::down) note(Extreme::least, low);
                direction = Direction::up;
                high = here;
            }
        }
    return extremes;
}

std::vector<FitCrossing> crossingsOf(Segments segments, double level) {
    std::vector<FitCrossing> crossings;
    if (segments.empty()) return crossings;
    const double fuzz = roundingOfValues * std::abs(level);
    const auto sideOf = [level](double value, double margin) {
        return value > level + margin ? 1 : value < level - margin ? -1 : 0;
    };
    int side = sideOf(segments.front().first, segments.front().error() + fuzz);
    std::vector<double> places;  // where the level is taken since the function was last clearly off it
    double accuracy = 0;
    for (const MonotoneSegment& segment : segments) {
        const double margin = segment.error() + fuzz;
        if (segment.lower() <= level && segment.upper() >= level && segment.lower() < segment.upper()) {
            places.push_back(segment.placeOf(level));
            const double slope = std::abs(segment.piece->outputs[segment.output].slope(places.back()));
            accuracy =
                std::min(segment.end - segment.start, margin / slope) + roundingOfValues * places.back();
        }
        const int now = sideOf(segment.last, margin);
        if (now == 0) continue;
        if (side != 0 && now != side && !places.empty())
            crossings.push_back(
                {{(places.front() + places.back()) / 2, (places.back() - places.front()) / 2 + accuracy},
                 now > 0});
        side = now;
        places.clear();
    }
    return crossings;
}

}  // namespace drillwave
