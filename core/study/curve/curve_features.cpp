// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/fit_features.h"

namespace drillwave {

namespace {

using Kind = CurveFeature::Kind;
using Shape = CurveFeature::Shape;
using Pieces = std::span<const FitPiece>;
using Segments = std::span<const MonotoneSegment>;

/// Short pieces between two that have slopes: where a function has no smooth course, wider than the pieces
/// that are halved towards such a place add up to.
constexpr double widestTurn = 1e-5;
/// A change of value over a sliver counts as a jump: relative to the values, and to what the slopes beside it
/// make of its width.
constexpr double leastJump = 1e-6;
constexpr double steepestSliver = 100;

/// A place where the curve is not smooth.
struct Turn {
    double start = 0;  ///< of the short pieces
    double end = 0;
    Estimate place = {};
    double before = 0;  ///< value on both sides of the sliver
    double after = 0;
    double error = 0;
    double slopeBefore = 0;  ///< per share
    double slopeAfter = 0;
    bool isJump = false;
};

double valueAt(const FitPiece& piece, double share) {
    return piece.outputs.front()(share);
}

/// Returns the mean slope over a piece.
double chordOf(const FitPiece& piece) {
    return (valueAt(piece, piece.end) - valueAt(piece, piece.start)) / (piece.end - piece.start);
}

/// Whether a piece is more than a sliver between others.
bool isWide(const FitPiece& piece) {
    return piece.solved && piece.end - piece.start > leastSlopeWidth;
}

/// Returns the turn between two wide pieces, `first` and `last`, where there is one.
std::optional<Turn> turnBetween(Pieces pieces, std::size_t first, std::size_t last, double scale) {
    const FitPiece& left = pieces[first];
    const FitPiece& right = pieces[last];
    if (right.start - left.end > widestTurn) return std::nullopt;
    Turn turn{.start = left.end, .end = right.start, .error = std::max(left.error[0], right.error[0])};
    turn.before = valueAt(left, left.end);
    turn.after = valueAt(right, right.start);
    turn.place = {left.end / 2 + right.start / 2, (right.start - left.end) / 2};
    // The steepest piece is the sliver, the others lead to it; of several the narrowest.
    double narrowest = INFINITY, steepestOfAll = -1;
    for (std::size_t i = first + 1; i < last; ++i) {
        const FitPiece& piece = pieces[i];
        if (!piece.solved) return std::nullopt;
        const double width = piece.end - piece.start;
        const double slope = std::abs(valueAt(piece, piece.end) - valueAt(piece, piece.start)) / width;
        const bool isJump = slope * width > leastJump * scale;
        if (isJump ? slope <= steepestOfAll : steepestOfAll >= 0 || width >= narrowest) continue;
        narrowest = width;
        if (isJump) steepestOfAll = slope;
        turn.place = {piece.start / 2 + piece.end / 2, narrowest};
        turn.before = valueAt(piece, piece.start);
        turn.after = valueAt(piece, piece.end);
    }
    const auto sides =
        sidesAt(pieces.subspan(first, last - first + 1), 0, turn.place.value, turn.place.value);
    turn.slopeBefore = sides ? sides->first.slope : chordOf(left);
    turn.slopeAfter = sides ? sides->second.slope : chordOf(right);
    const double steepest = std::max(std::abs(turn.slopeBefore), std::abs(turn.slopeAfter));
    turn.isJump = std::abs(turn.after - turn.before) >
                  leastJump * scale + steepestSliver * steepest * turn.place.error + 4 * turn.error;
    if (!turn.isJump && (!sides || !isAngle(sides->first, sides->second, scale))) return std::nullopt;
    return turn;
}

std::vector<Turn> turnsOf(Pieces pieces, double scale) {
    std::vector<Turn> turns;
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!isWide(pieces[i])) continue;
        if (before)
            if (const std::optional<Turn> turn = turnBetween(pieces, *before, i, scale))
                turns.push_back(*turn);
        before = i;
    }
    return turns;
}

/// Makes features of what was found over shares of a range.
class Finder {
  public:
    Finder(Pieces pieces, const CurveRange& range)
        : m_range(range),
          m_pieces(limitSliverErrors(pieces)),
          m_storage(segmentsOf(m_pieces, 0)),
          m_segments(m_storage) {
        for (const MonotoneSegment& segment : m_segments)
            m_scale = std::max({m_scale, std::abs(segment.first), std::abs(segment.last)});
        m_turns = turnsOf(pieces, m_scale);
    }

    std::vector<CurveFeature> find(std::span<const double> levels) {
        if (m_segments.empty()) return {};
        for (const LocalExtreme& extreme : localExtremesOf(m_segments))
            add(extreme.which, extreme.value, extreme.place);
        addOfAll(Extreme::least);
        addOfAll(Extreme::largest);
        for (const Turn& turn : m_turns) {
            if (!turn.isJump) keepOneExtremeOf(turn);
            addTurn(turn);
        }
        for (const double level : levels)
            for (const FitCrossing& crossing : crossingsOf(m_segments, level))
                if (!isJumpedOver(crossing)) addCrossing(crossing, level);
        std::ranges::stable_sort(m_features, {}, [](const CurveFeature& f) { return f.x.value; });
        return std::move(m_features);
    }

  private:
    Estimate placeOf(const Estimate& share) const {
        const double x = m_range.at(share.value);
        return {x, share.error * m_range.slopeAt(x)};
    }

    const Turn* turnAt(double share) const {
        const auto found = std::ranges::find_if(m_turns, [share](const Turn& turn) {
            return share >= turn.start - leastSlopeWidth && share <= turn.end + leastSlopeWidth;
        });
        return found == m_turns.end() ? nullptr : &*found;
    }

    bool isOf(const Turn& turn, const CurveFeature& feature) const {
        return turnAt(m_range.shareOf(feature.x.value)) == &turn;
    }

    /// Whether the curve jumps over the level there, and never has its value.
    bool isJumpedOver(const FitCrossing& crossing) const {
        const Turn* turn = turnAt(crossing.place.value);
        return turn && turn->isJump &&
               std::abs(crossing.place.value - turn->place.value) <= turn->place.error + crossing.place.error;
    }

    bool isOnGrid(double share) const {
        return std::ranges::any_of(m_pieces, [share](const FitPiece& piece) {
            return isWide(piece) && !piece.resolved && share >= piece.start - leastSlopeWidth &&
                   share <= piece.end + leastSlopeWidth;
        });
    }

    bool isEnd(double share) const {
        for (std::size_t i = 0; i < m_segments.size(); ++i) {
            const bool opens = i == 0 || m_segments[i].start - m_segments[i - 1].end > leastSlopeWidth;
            const bool closes =
                i + 1 == m_segments.size() || m_segments[i + 1].start - m_segments[i].end > leastSlopeWidth;
            if ((opens && share == m_segments[i].start) || (closes && share == m_segments[i].end))
                return true;
        }
        return false;
    }

    void describe(CurveFeature& feature, const Turn& turn) const {
        feature.shape = Shape::cusp;
        feature.slopeBefore = turn.slopeBefore / m_range.slopeAt(feature.x.value);
        feature.slopeAfter = turn.slopeAfter / m_range.slopeAt(feature.x.value);
    }

    CurveFeature& add(Extreme which, const Estimate& value, const Estimate& share) {
        CurveFeature feature{.kind = which == Extreme::least ? Kind::minimum : Kind::maximum};
        feature.value = value;
        feature.x = placeOf(share);
        if (const Turn* turn = turnAt(share.value))
            describe(feature, *turn);
        else if (isOnGrid(share.value))
            feature.shape = Shape::grid;
        else if (isEnd(share.value))
            feature.shape = Shape::end;
        m_features.push_back(feature);
        return m_features.back();
    }

    /// The least or largest of all may be one of the neighbourhoods.
    void addOfAll(Extreme which) {
        const FitExtreme found = extremeOf(m_segments, which);
        const Kind kind = which == Extreme::least ? Kind::minimum : Kind::maximum;
        const double x = m_range.at(found.place.value);
        const auto same = std::ranges::find_if(
            m_features, [&](const CurveFeature& f) { return f.kind == kind && f.x.value == x; });
        CurveFeature& feature = same != m_features.end() ? *same : add(which, found.value, found.place);
        feature.ofAll = true;
        feature.value = found.value;
        feature.x = placeOf(found.place);
        if (found.everywhere) feature.shape = Shape::everywhere;
    }

    /// Several extremes within one turn are one extreme, or none where the curve goes on as it came; those of
    /// the whole line stay.
    void keepOneExtremeOf(const Turn& turn) {
        const auto isOfTurn = [&](const CurveFeature& f) { return isOf(turn, f); };
        const auto count = std::ranges::count_if(m_features, isOfTurn);
        if (count < 2) return;
        const bool isKept =
            std::ranges::any_of(m_features, [&](const CurveFeature& f) { return isOfTurn(f) && f.ofAll; });
        const Kind kind = std::ranges::find_if(m_features, isOfTurn)->kind;
        const double sign = kind == Kind::maximum ? 1 : -1;
        double most = -std::numeric_limits<double>::infinity();
        for (const CurveFeature& f : m_features)
            if (isOfTurn(f) && f.kind == kind) most = std::max(most, sign * f.value.value);
        bool isFound = isKept || count % 2 == 0;
        std::erase_if(m_features, [&](const CurveFeature& f) {
            if (!isOfTurn(f) || f.ofAll) return false;
            if (isFound || f.kind != kind || sign * f.value.value < most) return true;
            isFound = true;
            return false;
        });
    }

    void addTurn(const Turn& turn) {
        if (!turn.isJump && std::ranges::any_of(m_features, [&](const CurveFeature& f) {
                return f.shape == Shape::cusp && isOf(turn, f);
            }))
            return;  // reported with the extreme
        CurveFeature feature{.kind = turn.isJump ? Kind::jump : Kind::kink};
        feature.x = placeOf(turn.place);
        feature.value = {turn.before, turn.error};
        feature.valueAfter = turn.after;
        describe(feature, turn);
        m_features.push_back(feature);
    }

    void addCrossing(const FitCrossing& crossing, double level) {
        CurveFeature feature{.kind = Kind::crossing};
        feature.x = placeOf(crossing.place);
        feature.value = {level, 0};
        feature.level = level;
        feature.rising = crossing.rising;
        if (const Turn* turn = turnAt(crossing.place.value))
            describe(feature, *turn);
        else if (isOnGrid(crossing.place.value))
            feature.shape = Shape::grid;
        m_features.push_back(feature);
    }

    const CurveRange& m_range;
    std::vector<FitPiece> m_pieces;
    std::vector<MonotoneSegment> m_storage;
    Segments m_segments;
    double m_scale = 0;
    std::vector<Turn> m_turns;
    std::vector<CurveFeature> m_features;
};

}  // namespace

std::vector<FitPiece> limitSliverErrors(std::span<const FitPiece> pieces) {
    std::vector<FitPiece> quiet(pieces.begin(), pieces.end());
    const auto nearest = [&](std::size_t i, int step) {
        for (std::size_t j = i + step; j < quiet.size(); j += step)  // wraps below 0
            if (pieces[j].resolved) return pieces[j].error.front();
        return 0.0;
    };
    for (std::size_t i = 0; i < quiet.size(); ++i)
        if (quiet[i].solved && !quiet[i].resolved && quiet[i].end - quiet[i].start <= leastSlopeWidth)
            quiet[i].error.front() =
                std::min(quiet[i].error.front(), std::max(nearest(i, -1), nearest(i, 1)));
    return quiet;
}

std::vector<CurveFeature> featuresOf(Pieces pieces, const CurveRange& range, std::span<const double> levels) {
    return Finder(pieces, range).find(levels);
}

}  // namespace drillwave
