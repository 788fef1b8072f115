// One case after another solved into the output cells of a table row.
#pragma once

#include <span>
#include <string>

#include "core/model/pulse_force.h"
#include "core/study/output_column.h"
#include "core/wave/exact_solver.h"

namespace drillwave {

/// Solves cases and keeps what they share. One for each thread.
class CaseSolver {
  public:
    /// `columns` must outlive the solver.
    explicit CaseSolver(std::span<const OutputColumn> columns);

    /// Must be called before solve() whenever the hammer blow may have changed.
    void setPulse(const Scenario& scenario) { m_pulse = pulseForceOf(scenario); }

    /// Appends ",value" for each column, "," alone where there is no number. False, and all cells empty, when
    /// the case could not be solved.
    bool solve(const Scenario& scenario, std::string& row);

  private:
    std::span<const OutputColumn> m_columns;
    Detail m_detail;
    bool m_inSi;
    ExactSolver m_solver;
    PulseForce m_pulse;
};

}  // namespace drillwave
