// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a line, and outputs that are only known at points.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve_sampler.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns shares of the range at which to draw and write a line: the ends of the pieces of all its outputs,
/// except slivers, no more than 1/500 apart and closer where a piece is open; one without a result.
std::vector<double> pointsOf(const CurveLine& line);

/// Returns those of `points` at which open pieces need values, and the ends of these pieces.
std::vector<double> openPointsOf(const CurveLine& line, std::span<const double> points);

/// All outputs at a point of a line, solved.
struct LinePoint {
    double share = 0;
    std::vector<FitSample> outputs;
    std::vector<Message> reasons;  ///< why there is none
};

/// Some points of one line.
struct PointTask {
    std::size_t line = 0;
    std::vector<double> shares;
    std::vector<LinePoint> points;
    std::uint64_t solves = 0;
    long effort = 0;  ///< of these
};

/// Solves the points of one task after another. One for each thread.
class PointSolver {
  public:
    /// Requires that both outlive it.
    PointSolver(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Fills a task of that line and shares.
    void operator()(PointTask& task, const std::stop_token& stop) const;

  private:
    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Fills the open pieces of output i with straight ones between solved points, ascending, which hold all of
/// openPointsOf().
void fillPieces(CurveLine& line, std::size_t i, std::span<const double> points,
                std::span<const LinePoint> solved);

}  // namespace drillwave
