// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm of the paper (Appendix A), as a second, independent solver (theory §6).
#pragma once

#include <memory>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Storage of the waves in the segments of the rod. The results are identical to the last bit.
enum class LatticeWaves {
    /// Waves are moved from segment to segment in each step; the work per step grows with the number L of
    /// segments.
    moved,
    /// Waves stay in a ring buffer; the work per step does not depend on the number of segments.
    ring,
};

/// Choice whether rods of fewer segments are also solved, to estimate the error.
enum class ErrorEstimate { none, fromOtherLattices };

/// Options of the lattice method. The paper uses 10 000 segments, and 20 000 "for accurate determination of
/// the COR".
struct LatticeOptions {
    /// Number L of segments of the rod, minimumSegments … maximumSegments.
    int segments = 10'000;
    /// Way in which the waves in the segments are stored. It changes the computing time, but not the results.
    LatticeWaves waves = LatticeWaves::ring;
    /// Whether the error is estimated from rods of fewer segments.
    ErrorEstimate estimate = ErrorEstimate::fromOtherLattices;
    bool operator==(const LatticeOptions&) const = default;
};

/// Allowed range of LatticeOptions::segments.
inline constexpr int minimumSegments = 10;
inline constexpr int maximumSegments = 1'000'000;

/// Solver for blows on a rod of L equal segments with the time step Δ = τ/L, which reuses its memory.
///
/// The hammer force is replaced by its means over the time steps. The impact force is constant in each step,
/// and does exactly the work of the bit–rock law (StepLaw). The solution ends when no further contact can
/// follow: after a round trip without contact, if the momentum is not towards the rock. Free flights of many
/// round trips are skipped.
///
/// The error of `cor` is proportional to Δ² if γ = 1, or if jumps of the hammer force fall on ends of steps;
/// otherwise it is between Δ and Δ². `corError` is an estimate, not a bound. It is twice the range of the
/// results for this number of segments and eight smaller ones, plus rounding. If those have too long steps,
/// larger numbers are used. If the error is proportional to Δ², the estimate is typically ten times too
/// large. It is NaN with ErrorEstimate::none.
///
/// `pieces` is the number of steps from the first arrival on. `peakForce` and events are those of the
/// force–penetration curve that the steps follow. The histories are constant in each step.
///
/// A blow is not solved, with a reason, if β/γ·Δ > 2 (a step would overshoot the unloading line), or if a
/// contact with impulse is shorter than a step. The same holds after too many steps or a stop request.
class LatticeSolver {
  public:
    LatticeSolver();
    ~LatticeSolver();
    LatticeSolver(LatticeSolver&&) noexcept;
    LatticeSolver& operator=(LatticeSolver&&) noexcept;

    /// Returns the solution of a blow. The requirements on `problem` are those of ExactSolver::solve().
    /// `stop` is checked at least every few milliseconds.
    Impact solve(const Problem& problem, Detail detail, const LatticeOptions& options,
                 const std::stop_token& stop = {});

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
};

}  // namespace drillwave
