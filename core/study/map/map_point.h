// SPDX-License-Identifier: GPL-3.0-or-later
// Solves any single point of a map.
#pragma once

#include <stop_token>
#include <vector>

#include "core/study/map/map.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/text/message.h"

namespace drillwave {

/// Solver for points of a map, which reuses intermediate results between neighbouring points. Each thread
/// needs its own object.
class MapPoint {
  public:
    /// Stores a reference to the study, which must outlive this object.
    explicit MapPoint(const MapStudy& study);

    /// Writes the output at x and y (SI, within the axes) to `value`; NaN if there is none. Returns why the
    /// blow could not be solved (`value` is then unchanged); empty if it was solved.
    Message solve(double x, double y, double& value, const std::stop_token& stop);

    /// Returns why the point solved last has no output; empty if it has one or if the reason is not known.
    /// The next function, isIrregular(), returns whether the motion in the sequence of blows at that point
    /// does not repeat.
    const Message& lack() const { return m_solver.lack(); }
    bool isIrregular() const { return m_solver.isIrregular(); }

  private:
    std::vector<SweepAxis> m_axes;
    AxisScenario m_scenario;
    CaseSolver m_solver;
    double m_x = 0, m_y = 0;  // values at which the hammer force was last set
    bool m_hasPulse = false;
};

}  // namespace drillwave
