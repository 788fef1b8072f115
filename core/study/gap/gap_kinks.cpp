// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_kinks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/numeric/fit_features.h"

namespace drillwave {

namespace {

/// Both sides of a gap in the period, whose end is also its beginning.
std::optional<std::pair<FitSide, FitSide>> sidesOf(const GapCurve& curve, std::size_t output, double gap) {
    const auto first = std::ranges::lower_bound(curve.pieces, curve.periodStart, {}, &GapPiece::start);
    return sidesAt({first, curve.pieces.end()}, output, gap == curve.periodStart ? curve.end : gap,
                   gap == curve.end ? curve.periodStart : gap);
}

std::optional<GapKink> kinkAt(const GapCurve& curve, double gap) {
    const auto sides = sidesOf(curve, 0, gap);
    if (!sides || !isAngle(sides->first, sides->second, 1)) return std::nullopt;
    const auto& [left, right] = *sides;
    return GapKink{.gap = gap,
                   .cor = curve.value(GapOutput::cor, gap),
                   .slopeBefore = left.slope,
                   .slopeAfter = right.slope,
                   .contactsBefore = left.piece->label,
                   .contactsAfter = right.piece->label};
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
