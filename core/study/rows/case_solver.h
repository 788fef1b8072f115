// SPDX-License-Identifier: GPL-3.0-or-later
// Solves one scenario after another into a row of output values.
#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "core/blow/method.h"
#include "core/study/rows/output_column.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/text/message.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Solver for a series of scenarios, which reuses what consecutive ones have in common, such as the hammer
/// force. Each thread needs its own object.
class CaseSolver {
  public:
    /// Stores a reference to `columns`, which must outlive the solver. The work of each case is limited to
    /// `workLimit` wave pieces. It is solved with detail `least`, or with more if the columns need it.
    CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit,
               Detail least = Detail::cor);

    /// Sets the hammer force from a scenario. Must be called before solve() whenever the hammer force may
    /// have changed.
    void setPulse(const Scenario& scenario) {
        if (isForced(scenario)) m_problem.drive = pulseForceOf(scenario);
    }

    /// Solves a scenario and writes one value for each column to `outputs`, NaN if a column has none. Returns
    /// why the scenario could not be solved (all outputs are then NaN); empty if it was solved.
    Message solve(const Scenario& scenario, std::span<double> outputs, const std::stop_token& stop);

    /// Returns why a column of the last case has no value although such scenarios normally have one; empty if
    /// the reason is not known.
    const Message& lack() const { return m_lack; }

    /// Returns whether the blows of the last case do not repeat periodically, so that their mean values
    /// scatter.
    bool isIrregular() const { return m_drill && m_drill->period == 0.0; }

    /// Returns the single blow solved in the last case. It is an unsolved default if the columns only need
    /// sequences of blows.
    const Impact& impact() const { return m_impact; }
    /// Returns the part of the error of e that varies at random from case to case; a curve through the cases
    /// need not follow it. For drill strings it is less than the stated error, which is mostly the same from
    /// case to case.
    double scatter() const { return m_scatter; }
    const Problem& problem() const { return m_problem; }

  private:
    Message solveDrillString(const Scenario& scenario, std::span<double> outputs,
                             const std::stop_token& stop);
    /// Writes the outputs of a uniform rod, from the summary of its blow, to `outputs`. Returns why they are
    /// not valid; empty if they are.
    Message fillFrom(const ImpactSummary& summary, const Scenario& scenario, std::span<double> outputs,
                     const std::stop_token& stop);
    /// Computes a sequence of blows if a column needs one and the scenario allows it. Returns why it failed;
    /// empty if it did not fail, and if the blows push the machine back.
    Message march(const Scenario& scenario, const std::stop_token& stop);
    /// Writes the outputs from `source`. Returns why the values are not valid (they are then NaN); empty if
    /// they are valid.
    Message fill(OutputSource source, std::span<double> outputs, const std::stop_token& stop);

    std::span<const OutputColumn> m_columns;
    Detail m_detail;
    bool m_needsBlow;  ///< whether a single blow must be solved
    bool m_needsLess;  ///< whether some column can be filled without histories
    bool m_inSi;
    bool m_needsMargin;  ///< whether the feed margin is needed, which requires a study of all gaps
    RequiredMarches m_drillWishes;
    WaveNumbers m_waveNumbers;
    MethodChoice m_method;
    MethodSolver m_solver;
    ThrustMargins m_margins;
    Problem m_problem;
    Impact m_impact;
    std::optional<DrillNumbers> m_drill;
    Message m_lack;
    double m_scatter = 0;
};

}  // namespace drillwave
