// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm of the paper (Appendix A), as a second, independent solver (theory §6).
#pragma once

#include <memory>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Way in which the waves in the segments of the rod are stored. Both ways give identical results, to the
/// last bit.
enum class LatticeWaves {
    /// Waves are moved from segment to segment in each step; the work per step grows with the number L of
    /// segments.
    moved,
    /// Waves stay in a ring buffer; the work per step does not depend on the number of segments.
    ring,
};

/// Choice whether the blow is also solved with other numbers of segments, to estimate the error of the
/// coefficient of restitution.
enum class ErrorEstimate { none, fromOtherLattices };

/// Options of the lattice method. The paper uses 10 000 segments, and 20 000 "for accurate determination of
/// the COR".
struct LatticeOptions {
    /// Number L of segments of the rod, minimumSegments … maximumSegments.
    int segments = 10'000;
    /// Way in which the waves in the segments are stored. It changes the computing time, but not the results.
    LatticeWaves waves = LatticeWaves::ring;
    /// Whether the error of the coefficient of restitution is estimated, from solutions with other numbers of
    /// segments.
    ErrorEstimate estimate = ErrorEstimate::fromOtherLattices;
    bool operator==(const LatticeOptions&) const = default;
};

/// Smallest and largest allowed number LatticeOptions::segments.
inline constexpr int minimumSegments = 10;
inline constexpr int maximumSegments = 1'000'000;

/// Solver for blows on a uniform rod, divided into L equal segments, with the time step Δ = τ/L. It uses its
/// memory again for the next blow.
///
/// The hammer force is replaced by its means over the time steps. The impact force is constant in each step,
/// and does exactly the work of the bit–rock law (StepLaw). The solution ends when no further contact can
/// follow: after a round trip without contact, if the momentum is not towards the rock. Free flights of many
/// round trips are skipped.
///
/// The error of `cor` is proportional to Δ² if γ = 1, or if jumps of the hammer force fall on ends of steps;
/// otherwise it is between Δ and Δ². `corError` is an estimate of this error, not a bound. It is twice the
/// spread of the results for this number of segments and eight smaller numbers, plus rounding. If the steps
/// of a smaller number are too long for the rock, a larger number is used. If the error is proportional to
/// Δ², the estimate is typically ten times too large. It is NaN with ErrorEstimate::none.
///
/// `pieces` is the number of steps from the first arrival at the bit on. `peakForce` and events are those of
/// the force–penetration curve that the steps follow. The histories are constant in each step.
///
/// A blow is not solved, with a reason, if β/γ·Δ > 2 (a step would overshoot the unloading line), or if a
/// contact with impulse is shorter than a step. The same holds after too many steps or a stop request.
class LatticeSolver {
  public:
    LatticeSolver();
    ~LatticeSolver();
    LatticeSolver(LatticeSolver&&) noexcept;
    LatticeSolver& operator=(LatticeSolver&&) noexcept;

    /// Returns the solution of a blow. Requires β > 0, 0 < γ ≤ 1, τ > 0, δ ≥ 0, all finite, and a force on a
    /// uniform rod (rodRefusal()). `stop` is checked at least every few milliseconds.
    Impact solve(const Problem& problem, Detail detail, const LatticeOptions& options,
                 const std::stop_token& stop = {});

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
};

}  // namespace drillwave
