// SPDX-License-Identifier: GPL-3.0-or-later
// How large the rebound may be where neither the gap nor the rock is known for sure.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <stop_token>

#include "core/blow/feed_estimate.h"
#include "core/study/gap/gap_curve.h"
#include "core/study/gap/gap_statistics.h"
#include "core/text/message.h"

namespace drillwave {

/// An e that follows from a curve over the gap, or why not.
struct GapRebound {
    Estimate cor;
    Message reason;        ///< why there is none; empty when there is
    bool stopped = false;  ///< on the stop token: nothing is known
    bool known() const { return !stopped && reason.isEmpty(); }
};

/// The two e of theory §10 that no single blow has. They only depend on the hammer force, β, γ and τ.
struct GapRebounds {
    GapRebound quantile;  ///< not exceeded at 95 % of all gaps, in this rock
    GapRebound worst;     ///< the largest of all gaps if the rock were elastic (γ = 1)

    /// Returns both, if known.
    std::optional<ReboundsOverGaps> known() const {
        if (!quantile.known() || !worst.known()) return std::nullopt;
        return ReboundsOverGaps{quantile.cor, worst.cor};
    }
};

/// The curve of e over one period of the gap.
GapCurve rockCurve(const Problem& problem, const std::stop_token& stop, const GapProgress& progress,
                   long mostPieces = anyNumberOfPieces);
/// Returns the curve on rock of the same stiffness, with γ = 1 and no corners, from no gap on.
GapCurve elasticCurve(Problem problem, const std::stop_token& stop, const GapProgress& progress,
                      long mostPieces = anyNumberOfPieces);

GapRebound quantileOf(const GapCurve& rock);
GapRebound worstOf(const GapCurve& elastic);

/// Finds the two for one problem after another, and remembers them while the hammer force stays the same. One
/// object per thread; results do not depend on earlier calls.
class GapReboundFinder {
  public:
    /// Sets the most wave pieces of a curve: one that needs more has no result.
    explicit GapReboundFinder(long mostPieces = anyNumberOfPieces) : m_mostPieces(mostPieces) {}

    /// Returns the rebounds of the problem, whatever its gap.
    GapRebounds of(const Problem& problem, const std::stop_token& stop);
    /// Remembers the result that of() would find.
    void remember(const Problem& problem, const GapRebounds& rebounds);

  private:
    void forgetOtherThan(const Problem& problem);

    long m_mostPieces;
    PulseForce m_hammer;
    BitRockLaw m_shape;                                       ///< of the law, for β and γ of 1
    std::map<std::array<double, 3>, GapRebound> m_quantiles;  // by β, γ, τ
    std::map<std::array<double, 2>, GapRebound> m_worst;      // by β, τ
};

}  // namespace drillwave
