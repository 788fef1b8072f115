// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_kinks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace drillwave {

namespace {

/// An angle that counts as a kink: change of slope, relative to the values or to the steeper side.
constexpr double leastAngle = 1e-3;
/// Shorter pieces are slivers around a kink; several kinks this close are one.
constexpr double leastSlopeWidth = 1e-6;

bool hasSlope(const GapPiece& piece) {
    return piece.resolved && piece.end - piece.start > leastSlopeWidth;
}

/// The nearest piece on one side of a gap that has a slope, and that slope.
struct Side {
    const GapPiece* piece;
    double slope;
    double error;
};

Side sideOf(const GapPiece& piece, std::size_t output, double gap) {
    // Markov's inequality for polynomials of degree 16 that are off by the error.
    const double error = 512 * piece.error[output] / (piece.end - piece.start);
    return {&piece, piece.outputs[output].slope(gap), error};
}

/// Both sides of a gap in the period, whose end is also its beginning; nullopt inside a piece, where nothing
/// turns.
std::optional<std::pair<Side, Side>> sidesOf(const GapCurve& curve, std::size_t output, double gap) {
    const auto first = std::ranges::lower_bound(curve.pieces, curve.periodStart, {}, &GapPiece::start);
    const double fromLeft = gap == curve.periodStart ? curve.end : gap;
    const double fromRight = gap == curve.end ? curve.periodStart : gap;
    const GapPiece* before = nullptr;
    const GapPiece* after = nullptr;
    for (auto piece = first; piece != curve.pieces.end(); ++piece) {
        if (!hasSlope(*piece)) continue;
        if (piece->start < fromRight && piece->end > fromRight) return std::nullopt;
        if (piece->end <= fromLeft) before = &*piece;
        if (piece->start >= fromRight && !after) after = &*piece;
    }
    if (!before || !after) return std::nullopt;
    return std::pair{sideOf(*before, output, before->end), sideOf(*after, output, after->start)};
}

bool isAngle(const Side& left, const Side& right, double scale) {
    const double steeper = std::max({scale, std::abs(left.slope), std::abs(right.slope)});
    return std::abs(right.slope - left.slope) > leastAngle * steeper + left.error + right.error;
}

std::optional<GapKink> kinkAt(const GapCurve& curve, double gap) {
    const auto sides = sidesOf(curve, 0, gap);
    if (!sides || !isAngle(sides->first, sides->second, 1)) return std::nullopt;
    const auto& [left, right] = *sides;
    return GapKink{.gap = gap,
                   .cor = curve.value(GapOutput::cor, gap),
                   .slopeBefore = left.slope,
                   .slopeAfter = right.slope,
                   .contactsBefore = left.piece->contacts,
                   .contactsAfter = right.piece->contacts};
}

}  // namespace

std::vector<GapKink> kinksOf(const GapCurve& curve) {
    std::vector<GapKink> kinks;
    for (const double border : curve.borders) {
        if (border <= curve.periodStart) continue;
        const std::optional<GapKink> kink = kinkAt(curve, border);
        const bool isNew = kinks.empty() || border - kinks.back().gap > leastSlopeWidth;
        if (kink && isNew) kinks.push_back(*kink);
    }
    return kinks;
}

bool isKink(const GapCurve& curve, GapOutput output, double gap, double scale) {
    const auto sides = sidesOf(curve, static_cast<std::size_t>(output), gap);
    return sides && isAngle(sides->first, sides->second, scale);
}

}  // namespace drillwave
