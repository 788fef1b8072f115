// SPDX-License-Identifier: GPL-3.0-or-later
// Solves blows along the parameter range of a curve, each once for all outputs.
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

/// Solver for the blows along one curve. It keeps all results, so that no blow is solved twice. Each thread
/// needs its own object.
class CurveSampler {
  public:
    /// Stores references to the question and its axes, which must outlive this object. `line` is the index of
    /// the value of the second parameter (family). Each blow may take the work limit of the question divided
    /// by `partOfLimit`.
    CurveSampler(const CurveQuestion& question, const std::vector<SweepAxis>& axes, std::size_t line,
                 std::stop_token stop, long partOfLimit = 1);

    /// Returns the value of an output at a share 0 … 1 of the range. Solves the blow there if it has not been
    /// solved before. The error estimate of the value is based on that of the coefficient of restitution e.
    FitSample operator()(double share, std::size_t output);
    /// Returns why there was no value in the most recent sample without one. A sample is the result of a call
    /// of operator().
    const Message& reason() const { return m_reason; }
    /// Returns the typical size of an output at a share 0 … 1 of the range, in the unit of its column. Errors
    /// are judged relative to this size. For example, it is the scale d0 for a penetration and 1 for a ratio.
    /// Returns 0 if there is no valid scenario.
    double unitAt(double share, std::size_t output);
    /// Returns the computing work of the blow at a share 0 … 1 of the range: number of polynomial wave
    /// pieces, or time steps × nodes for drill strings.
    long effortAt(double share) { return blowAt(share).pieces; }
    std::uint64_t solves() const { return m_blows.size(); }
    /// Returns the computing work of all blows so far: number of polynomial wave pieces, or time steps ×
    /// nodes for drill strings.
    long effort() const { return m_effort; }

  private:
    struct Blow {
        std::vector<double> values;  // values of all outputs; empty if the blow was not solved
        Message reason;
        Message lack;  // reason why one of the outputs has no value, if the reason is known
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
    std::vector<double> m_values;  // values of the axes, the followed parameter last
    bool m_pulseMoves;             // whether the hammer force changes with the parameter
    bool m_hasPulse = false;
    std::unordered_map<double, Blow> m_blows;  // solved blows, by their share of the range
    long m_effort = 0;
    Message m_reason;
};

}  // namespace drillwave
