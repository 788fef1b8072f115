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
    /// Stores a reference to `columns`, which must outlive the solver. Limits the work of each case to
    /// `workLimit` wave pieces (the solver's unit of work). `least` is the lowest level of detail of the
    /// solutions; columns may require a higher one.
    CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit,
               Detail least = Detail::cor);

    /// Stores the hammer force of a scenario for later calls of solve(). Must be called before solve()
    /// whenever the hammer force may have changed.
    void setPulse(const Scenario& scenario) {
        if (isForced(scenario)) m_problem.drive = pulseForceOf(scenario);
    }

    /// Solves a scenario and writes one value for each column to `outputs`, NaN if a column has no value.
    /// Returns why the scenario could not be solved; `outputs` then has no valid values. Returns an empty
    /// message if the scenario was solved.
    Message solve(const Scenario& scenario, std::span<double> outputs, const std::stop_token& stop);

    /// Returns why the last sequence of blows has no statistics, such as a mean penetration rate. Columns
    /// that need them then have no value. Empty if the sequence has statistics or if none was computed.
    const Message& lack() const { return m_lack; }

    /// Returns whether the blows of the last case do not repeat periodically, so that their mean values
    /// scatter.
    bool isIrregular() const { return m_drill && m_drill->period == 0.0; }

    /// Returns the single blow solved in the last case. It is an unsolved default if the columns only need
    /// sequences of blows.
    const Impact& impact() const { return m_impact; }
    /// Returns the part of the error of e that varies at random from case to case. A curve fitted through
    /// the cases need not follow this scatter. For drill strings it is less than the stated error, which is
    /// nearly the same in all cases.
    double scatter() const { return m_scatter; }
    const Problem& problem() const { return m_problem; }

  private:
    Message solveDrillString(const Scenario& scenario, std::span<double> outputs,
                             const std::stop_token& stop);
    /// Writes the outputs of a blow in a uniform rod to `outputs`, computed from the summary of the blow.
    /// Returns why they are not valid; empty if they are.
    Message fillFrom(const ImpactSummary& summary, const Scenario& scenario, std::span<double> outputs,
                     const std::stop_token& stop);
    /// Computes a sequence of blows if a column needs one and the scenario allows it. Returns why the
    /// sequence gives no result. Empty if it gives one, if no sequence was computed, or if the blows push
    /// the machine back.
    Message march(const Scenario& scenario, const std::stop_token& stop);
    /// Writes the value of each column, taken from `source` and from a sequence of blows if a column needs
    /// one. Returns why the values are not valid, for example because one is infinite. In this case
    /// `outputs` has no valid values. Returns an empty message if they are valid.
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
