// SPDX-License-Identifier: GPL-3.0-or-later
// How likely each gap between bit and rock is, folded into the stretch of gap that is known.
#pragma once

#include <vector>

#include "core/study/gap/gap_curve.h"

namespace drillwave {

/// A gap scattered normally about a mean, in d0; cut off at 0, because a gap cannot be negative.
struct NormalGap {
    double mean = 0;       ///< ≥ 0, before the cut
    double deviation = 0;  ///< standard deviation before the cut, leastDeviation … mostDeviation
    static constexpr double leastDeviation = 1e-6;
    static constexpr double mostDeviation = 100;
};

/// A distribution of the gap on [start, end) of a curve, every gap beyond being taken back by whole periods.
class GapDistribution {
  public:
    /// Returns equal probability for all gaps of one period.
    static GapDistribution uniform(const GapCurve& curve);
    /// The curve must begin no later than lowestGap(normal).
    static GapDistribution normal(const GapCurve& curve, const NormalGap& normal);

    /// Probability per d0 at a gap of the curve.
    double density(double gap) const;
    /// Returns the probability that the folded gap is at most `gap`.
    double cumulative(double gap) const;
    /// Ascending gaps between which the density is smooth on the scale of their distance, or that scale is
    /// the whole curve.
    const std::vector<double>& cuts() const { return m_cuts; }

  private:
    GapDistribution(const GapCurve& curve, const NormalGap& normal);
    double fold(double gap) const;

    double m_periodStart = 0;
    bool m_uniform = true;
    NormalGap m_normal;
    double m_total = 1;  // probability that is left behind the cut
    std::vector<double> m_cuts;
};

/// Below this gap a normal distribution has nothing.
double lowestGap(const NormalGap& normal);

}  // namespace drillwave
