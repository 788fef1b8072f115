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

/// Coefficient of restitution e derived from a curve over all gaps, or the reason why there is none.
struct GapRebound {
    Estimate cor;
    Message reason;        ///< reason why there is no value; empty if there is one
    bool stopped = false;  ///< set if the stop token ended the computation; nothing is then known
    bool known() const { return !stopped && reason.isEmpty(); }
};

/// Two coefficients of restitution e, each of which considers all gaps between bit and rock. The required
/// feed forces follow from them (theory §10). They depend only on the hammer force, on β, γ and τ, and on
/// the shape of the rock law.
struct GapRebounds {
    GapRebound quantile;  ///< value that e does not exceed at 95 % of all gaps, for this rock
    GapRebound worst;     ///< largest e over all gaps if the rock were elastic (γ = 1)

    /// Returns the values of e in `quantile` and `worst`; empty if either of them is not known.
    std::optional<ReboundsOverGaps> known() const {
        if (!quantile.known() || !worst.known()) return std::nullopt;
        return ReboundsOverGaps{quantile.cor, worst.cor};
    }
};

/// Returns the coefficient of restitution e as a function of the gap between bit and rock, over one period.
/// The work of all blows is limited to `mostPieces` wave pieces, the solver's unit of work. If more is
/// needed, the curve is incomplete.
GapCurve rockCurve(const Problem& problem, const std::stop_token& stop, const GapProgress& progress,
                   long mostPieces = anyNumberOfPieces);
/// Returns the coefficient of restitution e as a function of the gap between bit and rock, for gaps from 0.
/// The rock is replaced by a linear elastic one (γ = 1) with the same loading stiffness. The work of all
/// blows is limited to `mostPieces` wave pieces, the solver's unit of work. If more is needed, the curve is
/// incomplete.
GapCurve elasticCurve(Problem problem, const std::stop_token& stop, const GapProgress& progress,
                      long mostPieces = anyNumberOfPieces);

/// Returns the value of e that is not exceeded at 95 % of all gaps of the curve.
GapRebound quantileOf(const GapCurve& rock);
/// Returns the largest coefficient of restitution e at any gap of a curve. If the curve is incomplete,
/// returns the reason instead.
GapRebound worstOf(const GapCurve& elastic);

/// Solver for the two coefficients of restitution e in GapRebounds, from which the required feed force over
/// all gaps follows. Keeps its results as long as the hammer force stays the same. Each thread needs its own
/// object; results do not depend on earlier calls.
class GapReboundFinder {
  public:
    /// Sets the maximum work of each curve over the gaps, in wave pieces (the solver's unit of work). A curve
    /// that needs more has no result.
    explicit GapReboundFinder(long mostPieces = anyNumberOfPieces) : m_mostPieces(mostPieces) {}

    /// Returns the two coefficients of restitution over all gaps for a problem, whose own gap is ignored.
    /// Computes them only if they are not known from earlier calls.
    GapRebounds of(const Problem& problem, const std::stop_token& stop);
    /// Stores known values of e for a problem, so that of() returns them without computing.
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
