// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of an uncontrolled gap on the results of a blow.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/study/gap/gap_curve.h"
#include "core/study/gap/gap_distribution.h"
#include "core/study/gap/gap_kinks.h"

namespace drillwave {

/// Minimum or maximum of an output over all gaps, and one gap where it occurs.
struct GapExtreme {
    Estimate value;
    /// Gap at which the extreme occurs [d0], within one period. The error of this gap is the distance over
    /// which the output differs from the extreme by less than its error.
    Estimate gap;
    enum class Kind { smooth, kink, everywhere } kind = Kind::smooth;
};

/// Probabilities for which the quantiles are given: 5 %, 50 % and 95 %.
inline constexpr std::array<double, 3> gapQuantiles{0.05, 0.5, 0.95};

/// Mean and quantiles of an output if the gap has a given probability distribution.
struct GapSpread {
    Estimate mean;
    std::array<Estimate, gapQuantiles.size()> quantiles;  ///< quantiles in the order of gapQuantiles
};

struct GapOutputStatistics {
    GapExtreme least;
    GapExtreme largest;
    GapSpread uniform;
    std::optional<GapSpread> normal;
};

/// Gap at which the coefficient of restitution e crosses 1.
struct GapCrossing {
    Estimate gap;
    bool rising = false;  ///< whether e increases with the gap where it crosses 1
};

struct GapStatistics {
    /// Statistics of each output, in the order of GapOutput, as many as the curve has.
    std::vector<GapOutputStatistics> outputs;
    Estimate shareAboveOne;  ///< probability of e > 1 with all gaps equally likely
    std::optional<Estimate> normalShareAboveOne;
    std::vector<GapCrossing> crossings;  ///< gaps of one period at which e crosses 1
    std::vector<GapKink> kinks;          ///< gaps of one period at which the slope of e jumps

    const GapOutputStatistics& of(GapOutput output) const {
        return outputs[static_cast<std::size_t>(output)];
    }
};

/// Returns statistics of the results for an uncertain gap: with all gaps of one period equally likely and, if
/// given, with the distribution `normal`. Statistics of the impulse follow from those of e, because the
/// impulse is 1 + e. Gaps without a result are left out.
/// Requires a usable curve with results nearly everywhere. With `normal`, the curve must begin at or below
/// lowestGap(*normal).
GapStatistics gapStatistics(const GapCurve& curve, const std::optional<NormalGap>& normal = {});

/// Returns the share of the gaps of one period, 0 … 1, for which e is larger than `cor`. It is the
/// probability of such an e if all gaps are equally likely.
Estimate shareAbove(const GapCurve& curve, double cor);

/// Returns the largest coefficient of restitution e over all gaps of the curve, including those before the
/// first period.
Estimate largestCor(const GapCurve& curve);

}  // namespace drillwave
