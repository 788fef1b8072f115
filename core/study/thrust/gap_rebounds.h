// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the rebound if neither the gap nor the rock is known exactly.
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

/// Coefficient of restitution e derived from a curve over all gaps, or the reason why it is missing.
struct GapRebound {
    Estimate cor;
    Message reason;        ///< reason why there is no value; empty if there is one
    bool stopped = false;  ///< set if the stop token ended the computation; nothing is then known
    bool known() const { return !stopped && reason.isEmpty(); }
};

/// Two values of e over all gaps, for the required feed force (theory §10). They depend only on the hammer
/// force, β, γ and τ.
struct GapRebounds {
    GapRebound quantile;  ///< value that e does not exceed at 95 % of all gaps, for this rock
    GapRebound worst;     ///< largest e over all gaps if the rock were elastic (γ = 1)

    /// Returns both values; empty if either is not known.
    std::optional<ReboundsOverGaps> known() const {
        if (!quantile.known() || !worst.known()) return std::nullopt;
        return ReboundsOverGaps{quantile.cor, worst.cor};
    }
};

/// Returns the coefficient of restitution e over one period of the gap. The curve takes at most `mostPieces`
/// wave pieces.
GapCurve rockCurve(const Problem& problem, const std::stop_token& stop, const GapProgress& progress,
                   long mostPieces = anyNumberOfPieces);
/// Returns the coefficient of restitution e over all gaps, from 0, on elastic rock (γ = 1) of the same
/// stiffness without corners. The curve takes at most `mostPieces` wave pieces.
GapCurve elasticCurve(Problem problem, const std::stop_token& stop, const GapProgress& progress,
                      long mostPieces = anyNumberOfPieces);

/// Returns the value of e that is not exceeded at 95 % of all gaps of the curve.
GapRebound quantileOf(const GapCurve& rock);
/// Returns the largest e over all gaps of the curve.
GapRebound worstOf(const GapCurve& elastic);

/// Solver for two coefficients of restitution e over all gaps. One is not exceeded at 95 % of the gaps, the
/// other is the largest on elastic rock. Keeps its results as long as the hammer force stays the same. Each
/// thread needs its own object; results do not depend on earlier calls.
class GapReboundFinder {
  public:
    /// Sets the maximum number of wave pieces of a curve. A curve that needs more has no result.
    explicit GapReboundFinder(long mostPieces = anyNumberOfPieces) : m_mostPieces(mostPieces) {}

    /// Returns the values of e over all gaps for a problem; its own gap is ignored.
    GapRebounds of(const Problem& problem, const std::stop_token& stop);
    /// Stores known values of e, so that of() returns them without computing.
    void remember(const Problem& problem, const GapRebounds& rebounds);

  private:
    void forgetOtherThan(const Problem& problem);

    long m_mostPieces;
    PulseForce m_hammer;
    BitRockLaw m_shape;                                       ///< rock law with β and γ set to 1
    std::map<std::array<double, 3>, GapRebound> m_quantiles;  // values by β, γ and τ
    std::map<std::array<double, 2>, GapRebound> m_worst;      // values by β and τ
};

}  // namespace drillwave
