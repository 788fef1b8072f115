// SPDX-License-Identifier: GPL-3.0-or-later
// One case after another solved into the outputs of a row.
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

/// Solves cases and keeps their common part. One object per thread.
class CaseSolver {
  public:
    /// `columns` must outlive the solver; a case may take `workLimit` wave pieces. It is solved with `least`
    /// or as much more as the columns take.
    CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit,
               Detail least = Detail::cor);

    /// Must be called before solve() whenever the hammer blow may have changed.
    void setPulse(const Scenario& scenario) {
        if (isForced(scenario)) m_problem.drive = pulseForceOf(scenario);
    }

    /// Puts a number for each column into `outputs`, NaN where there is none. Returns why the case could not
    /// be solved (there are none then), or nothing.
    Message solve(const Scenario& scenario, std::span<double> outputs, const std::stop_token& stop);

    /// Why the case last solved has no number in a column that such scenarios have; empty where that is not
    /// known.
    const Message& lack() const { return m_lack; }

    /// Returns whether many blows of the case last solved do not repeat: their means scatter.
    bool isIrregular() const { return m_drill && m_drill->period == 0.0; }

    /// Returns the impact of the case last solved; nothing if only columns of many blows were requested.
    const Impact& impact() const { return m_impact; }
    /// Returns the scatter of e of neighbouring blows, which a curve need not resolve. For strings it is less
    /// than the stated error, most of which is the same from blow to blow.
    double scatter() const { return m_scatter; }
    const Problem& problem() const { return m_problem; }

  private:
    Message solveDrillString(const Scenario& scenario, std::span<double> outputs,
                             const std::stop_token& stop);
    /// Fills in the outputs of the uniform rod last solved.
    Message fillFrom(const ImpactSummary& summary, const Scenario& scenario, std::span<double> outputs,
                     const std::stop_token& stop);
    /// Marches if a column is of many blows. Returns why that has no result.
    Message march(const Scenario& scenario, const std::stop_token& stop);
    /// Returns why the numbers are no result, and puts none then.
    Message fill(OutputSource source, std::span<double> outputs, const std::stop_token& stop);

    std::span<const OutputColumn> m_columns;
    Detail m_detail;
    bool m_needsBlow;  ///< the single one
    bool m_needsLess;  ///< some column can be filled without histories
    bool m_inSi;
    bool m_needsMargin;  ///< of the thrust: a study of all gaps
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
