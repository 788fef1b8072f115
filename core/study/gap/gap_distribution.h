// SPDX-License-Identifier: GPL-3.0-or-later
// Probability of each gap between bit and rock, folded into the range of gaps that a curve covers.
#pragma once

#include <vector>

#include "core/study/gap/gap_curve.h"

namespace drillwave {

/// Normal distribution of the dimensionless gap d/d0, truncated at 0 because a gap cannot be negative.
struct NormalGap {
    double mean = 0;       ///< mean of the normal distribution before truncation, ≥ 0 [d0]
    double deviation = 0;  ///< standard deviation before truncation, leastDeviation … mostDeviation [d0]
    static constexpr double leastDeviation = 1e-6;
    static constexpr double mostDeviation = 100;
};

/// Probability distribution of the gap over the range [start, end) of a curve. Larger gaps are shifted back
/// by whole periods, because the results of a blow repeat.
class GapDistribution {
  public:
    /// Returns a distribution in which all gaps of one period are equally likely. The period is the last unit
    /// of δ of the curve, after which the results of a blow repeat.
    static GapDistribution uniform(const GapCurve& curve);
    /// Returns a normal distribution, truncated at 0. Requires that the curve begins at or below
    /// lowestGap(normal).
    static GapDistribution normal(const GapCurve& curve, const NormalGap& normal);

    /// Returns the probability density at a gap of the curve, per unit of δ = d/d0.
    double density(double gap) const;
    /// Returns the probability, 0 … 1, that the gap is at most `gap`. If `gap` is beyond the end of the
    /// curve, it is first shifted back by whole periods.
    double cumulative(double gap) const;
    /// Returns ascending gaps that divide the range of the curve into intervals for numerical integration.
    /// The density is smooth within each interval.
    const std::vector<double>& cuts() const { return m_cuts; }

  private:
    GapDistribution(const GapCurve& curve, const NormalGap& normal);
    double fold(double gap) const;

    double m_periodStart = 0;
    bool m_uniform = true;
    NormalGap m_normal;
    double m_total = 1;  // probability left after truncation
    std::vector<double> m_cuts;
};

/// Returns the gap d/d0 below which the probability of a normal distribution is negligible. A curve for this
/// distribution must start at or below that gap.
double lowestGap(const NormalGap& normal);

}  // namespace drillwave
