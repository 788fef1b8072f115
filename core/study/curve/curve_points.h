// SPDX-License-Identifier: GPL-3.0-or-later
// Points at which a curve is drawn, and curves that are only known at points.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve_sampler.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the shares of the range, 0 … 1, at which to draw and export a line. These are the ends of all
/// pieces except slivers, plus points so that the spacing is at most 1/500. The spacing is closer where a
/// piece has no function yet. A piece without a result gets one point.
std::vector<double> pointsOf(const CurveLine& line);

/// Returns the shares of the range, 0 … 1, at which blows must still be solved. These are the entries of
/// `points` in open pieces (parts of a curve without a function), and the ends of these pieces.
std::vector<double> openPointsOf(const CurveLine& line, std::span<const double> points);

/// Values of all outputs, from the blow solved at one parameter value.
struct LinePoint {
    double share = 0;
    std::vector<FitSample> outputs;
    /// Reason why each output has no value; empty messages for outputs with a value.
    std::vector<Message> reasons;
};

/// Points of one curve to be solved together by one thread.
struct PointTask {
    std::size_t line = 0;
    std::vector<double> shares;
    std::vector<LinePoint> points;
    std::uint64_t solves = 0;
    /// Computing work of all blows of this task: polynomial pieces of waves, or for drill strings time steps
    /// times nodes.
    long effort = 0;
};

/// Functor that solves all points of a task. Each thread needs its own object.
class PointSolver {
  public:
    /// Stores references to both arguments, which must outlive this object.
    PointSolver(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Solves the blows at the shares of the range given in a task. Stores the results, and the number and
    /// work of the blows, in the task.
    void operator()(PointTask& task, const std::stop_token& stop) const;

  private:
    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Fills the open pieces (parts of a curve without a function) of output i with straight lines between solved
/// points. Requires that `solved` is ascending and includes every share that openPointsOf() returns.
void fillPieces(CurveLine& line, std::size_t i, std::span<const double> points,
                std::span<const LinePoint> solved);

}  // namespace drillwave
