// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's own algorithm (Appendix A) as a second, independent solver (theory §6).
#pragma once

#include <memory>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Storage of the waves of the lattice. The results are identical to the last bit.
enum class LatticeWaves {
    moved,  ///< moved from segment to segment as in the paper: O(L) per step
    ring,   ///< standing in a ring buffer: O(1) per step
};

/// Whether coarser lattices are also solved, to estimate the error.
enum class ErrorEstimate { none, fromOtherLattices };

/// The paper's choice is 10 000 segments, and 20 000 "for accurate determination of the COR".
struct LatticeOptions {
    int segments = 10'000;  ///< L, minimumSegments … maximumSegments
    LatticeWaves waves = LatticeWaves::ring;
    ErrorEstimate estimate = ErrorEstimate::fromOtherLattices;
    bool operator==(const LatticeOptions&) const = default;
};

inline constexpr int minimumSegments = 10;
inline constexpr int maximumSegments = 1'000'000;

/// Solves one blow after another on a rod of equal segments, time step Δ = τ/L, keeping its memory.
///
/// The hammer force enters by its means over the steps; the impact force is constant in each step and does
/// exactly the work of the bilinear law (StepLaw). It stops on the same proof as ExactSolver: a whole
/// period without contact and momentum not towards the rock; free flights of many periods are skipped.
///
/// The result: `cor` has an error that falls with Δ² where γ = 1 or fronts fall on ends of steps, between Δ
/// and Δ² elsewhere. `corError` is twice the range of the results of this lattice and eight coarser ones
/// (comparisonLattices(); finer ones where those are too coarse), plus rounding. It is an estimate, not a
/// bound; the factor covers what eight samples miss of the range of an error that falls with Δ only, and
/// makes it ten times too large, typically, where the error falls with Δ². It is NaN with
/// ErrorEstimate::none. `pieces` are the steps from the first arrival on; `peakForce` and events are those of
/// the force–penetration curve that the steps follow; the histories are constant in each step.
///
/// Not solved, with the reason: β/γ·Δ > 2 (a step would overshoot the unloading line), a contact with impulse
/// that is shorter than a step, more steps than permitted, stopped.
class LatticeSolver {
  public:
    LatticeSolver();
    ~LatticeSolver();
    LatticeSolver(LatticeSolver&&) noexcept;
    LatticeSolver& operator=(LatticeSolver&&) noexcept;

    /// The problem is as for ExactSolver::solve(). Checks `stop` at least every few milliseconds.
    Impact solve(const Problem& problem, Detail detail, const LatticeOptions& options,
                 const std::stop_token& stop = {});

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
};

}  // namespace drillwave
