// SPDX-License-Identifier: GPL-3.0-or-later
// One case after another solved into the output cells of a table row.
#pragma once

#include <span>
#include <stop_token>
#include <string>

#include "core/blow/method.h"
#include "core/study/rows/output_column.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Solves cases and keeps what they share. One for each thread.
class CaseSolver {
  public:
    /// `columns` must outlive the solver; a case may take `workLimit` wave pieces.
    CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit);

    /// Must be called before solve() whenever the hammer blow may have changed.
    void setPulse(const Scenario& scenario) { m_problem.hammer = pulseForceOf(scenario); }

    /// Appends ",value" for each column, "," alone where there is no number. Returns why the case could not
    /// be solved (all cells are empty then), or an empty string.
    std::string solve(const Scenario& scenario, std::string& row, const std::stop_token& stop);

  private:
    std::span<const OutputColumn> m_columns;
    Detail m_detail;
    bool m_inSi;
    MethodChoice m_method;
    MethodSolver m_solver;
    Problem m_problem;
};

}  // namespace drillwave
