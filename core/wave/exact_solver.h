// The event-driven exact solution of the scalar delay equation (theory §3).
#pragma once

#include <memory>

#include "core/model/pulse_force.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Solves one blow after another, keeping its workspace: no heap allocation per solve once warm when
/// Detail::cor is asked for. One solver per thread.
class ExactSolver {
  public:
    /// `mostPieces` bounds the work of one solve (about 0.05 µs each): beyond it the outcome is notSolved.
    explicit ExactSolver(long mostPieces = 30'000'000);
    ~ExactSolver();
    ExactSolver(ExactSolver&&) noexcept;
    ExactSolver& operator=(ExactSolver&&) noexcept;

    /// Solves `pulse` on the rod and rock of `groups` (β > 0, 0 < γ ≤ 1, τ > 0, δ ≥ 0, all finite).
    Impact solve(const PulseForce& pulse, const Groups& groups, Detail detail = Detail::cor);

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
    long m_mostPieces;
};

}  // namespace drillwave
