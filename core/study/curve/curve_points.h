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

/// Returns the positions, as shares 0 … 1 of the range, at which to draw and export a line. The spacing is at
/// most 1/500, and closer in parts of a curve without a function. The ends of all parts (pieces) are
/// included, except tiny ones around kinks. A piece without a result gets one point.
std::vector<double> pointsOf(const CurveLine& line);

/// Returns the positions, as shares 0 … 1 of the range, at which blows must still be solved. These are the
/// entries of `points` in open pieces (parts of a curve without a function), and the ends of these pieces.
std::vector<double> openPointsOf(const CurveLine& line, std::span<const double> points);

/// Values of all outputs, from the blow solved at one parameter value.
struct LinePoint {
    double share = 0;
    std::vector<FitSample> outputs;
    /// Reasons why outputs have no value, one entry for each output; an empty message if the output has a
    /// value.
    std::vector<Message> reasons;
};

/// Points of one curve whose blows one thread solves together.
struct PointTask {
    std::size_t line = 0;
    std::vector<double> shares;
    std::vector<LinePoint> points;
    std::uint64_t solves = 0;
    /// Computing work of all blows of this task: number of polynomial wave pieces, or time steps × nodes for
    /// drill strings.
    long effort = 0;
};

/// Functor that solves the blows at all points of a PointTask. Each thread needs its own object.
class PointSolver {
  public:
    /// Stores references to both arguments, which must outlive this object.
    PointSolver(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Solves the blows at the parameter values in PointTask::shares. Stores their results, their number and
    /// the computing work in the task.
    void operator()(PointTask& task, const std::stop_token& stop) const;

  private:
    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Replaces the open pieces of output i (parts of its curve without a function) with straight lines between
/// solved points. Requires that `solved` is ascending and includes every share that openPointsOf() returns.
void fillPieces(CurveLine& line, std::size_t i, std::span<const double> points,
                std::span<const LinePoint> solved);

}  // namespace drillwave
