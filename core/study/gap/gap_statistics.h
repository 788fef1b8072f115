// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of an uncontrolled gap on the result of a blow.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/study/gap/gap_curve.h"
#include "core/study/gap/gap_distribution.h"
#include "core/study/gap/gap_kinks.h"

namespace drillwave {

/// The least or largest value over all gaps, and a gap where it is taken.
struct GapExtreme {
    Estimate value;
    Estimate gap;  ///< d0, in the period; its error is how far the value stays within its own error
    enum class Kind { smooth, kink, everywhere } kind = Kind::smooth;
};

/// Shares for which the quantiles are given.
inline constexpr std::array<double, 3> gapQuantiles{0.05, 0.5, 0.95};

/// An output under a distribution of the gap.
struct GapSpread {
    Estimate mean;
    std::array<Estimate, gapQuantiles.size()> quantiles;  ///< of gapQuantiles
};

struct GapOutputStatistics {
    GapExtreme least;
    GapExtreme largest;
    GapSpread uniform;
    std::optional<GapSpread> normal;
};

/// A gap at which e = 1.
struct GapCrossing {
    Estimate gap;
    bool rising = false;  ///< with growing gap
};

struct GapStatistics {
    std::vector<GapOutputStatistics> outputs;  ///< in the order of GapOutput, as many as the curve has
    Estimate shareAboveOne;                    ///< share of gaps with e > 1, all gaps alike
    std::optional<Estimate> normalShareAboveOne;
    std::vector<GapCrossing> crossings;  ///< in one period
    std::vector<GapKink> kinks;          ///< in one period

    const GapOutputStatistics& of(GapOutput output) const {
        return outputs[static_cast<std::size_t>(output)];
    }
};

/// Returns statistics over one period of the gap, with equal probability, and for a gap scattered as in
/// `normal`. The impulse is 1 + e: so are its statistics. Requires a usable curve with results nearly
/// everywhere (gaps without a result are left out), beginning no later than lowestGap(*normal).
GapStatistics gapStatistics(const GapCurve& curve, const std::optional<NormalGap>& normal = {});

/// Share of one period of the gap, all gaps alike, with a larger e than that.
Estimate shareAbove(const GapCurve& curve, double cor);

/// Returns the largest e over all gaps of the curve, also those before the period.
Estimate largestCor(const GapCurve& curve);

}  // namespace drillwave
