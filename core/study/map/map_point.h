// SPDX-License-Identifier: GPL-3.0-or-later
// Any one point of a map, solved.
#pragma once

#include <stop_token>
#include <vector>

#include "core/study/map/map.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/text/message.h"

namespace drillwave {

/// Solves points of a map and keeps the common part of neighbours. One object per thread.
class MapPoint {
  public:
    /// The study must outlive it.
    explicit MapPoint(const MapStudy& study);

    /// Writes the output at these values (SI, within the axes) into `value`, NaN if there is none. Returns
    /// why the blow could not be solved (`value` is then unchanged), or nothing.
    Message solve(double x, double y, double& value, const std::stop_token& stop);

    /// Why the point last solved has no output, and whether its blows do not repeat (CaseSolver).
    const Message& lack() const { return m_solver.lack(); }
    bool isIrregular() const { return m_solver.isIrregular(); }

  private:
    std::vector<SweepAxis> m_axes;
    AxisScenario m_scenario;
    CaseSolver m_solver;
    double m_x = 0, m_y = 0;  // of the pulse
    bool m_hasPulse = false;
};

}  // namespace drillwave
