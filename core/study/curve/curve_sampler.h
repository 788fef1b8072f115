// SPDX-License-Identifier: GPL-3.0-or-later
// Blows along the range of a curve, each solved once for all outputs.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "core/study/curve/curve.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/text/message.h"

namespace drillwave {

/// Solves the blows of one line. One for each thread.
class CurveSampler {
  public:
    /// `axes` are those of the question, `line` the number of the line; all must outlive this. A blow may
    /// take one such part of the work limit.
    CurveSampler(const CurveQuestion& question, const std::vector<SweepAxis>& axes, std::size_t line,
                 std::stop_token stop, long partOfLimit = 1);

    /// Returns an output at a share of the range, with an error like that of e.
    FitSample operator()(double share, std::size_t output);
    /// Why there was no answer for the last sample that had none.
    const Message& reason() const { return m_reason; }
    /// Returns the size of the numbers of an output in its unit, at a share of the range: d0 for a
    /// penetration and so on; 1 for a ratio; 0 if there is no scenario.
    double unitAt(double share, std::size_t output);
    /// Returns the work of the blow at a share of the range: wave pieces, or cells of a drill string.
    long effortAt(double share) { return blowAt(share).pieces; }
    std::uint64_t solves() const { return m_blows.size(); }
    /// Returns the work of all blows so far.
    long effort() const { return m_effort; }

  private:
    struct Blow {
        std::vector<double> values;  // of all outputs; none where it was not solved
        Message reason;
        Message lack;  // why an output of it has none, where that is known
        double scatter = 0;
        std::uint64_t order = 0;
        int contacts = 0;
        long pieces = 0;
    };
    const Blow& blowAt(double share);
    const Scenario& scenarioAt(double share);

    const CurveQuestion& m_question;
    CurveRange m_range;
    std::stop_token m_stop;
    AxisScenario m_scenario;
    CaseSolver m_solver;
    std::vector<double> m_values;  // of the axes
    bool m_pulseMoves;             // with the parameter
    bool m_hasPulse = false;
    std::unordered_map<double, Blow> m_blows;  // by share
    long m_effort = 0;
    Message m_reason;
};

}  // namespace drillwave
