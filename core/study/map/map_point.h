// SPDX-License-Identifier: GPL-3.0-or-later
// Any one point of a map, solved.
#pragma once

#include <span>
#include <stop_token>
#include <string>

#include "core/model/assignments.h"
#include "core/study/map/map.h"
#include "core/study/rows/case_solver.h"

namespace drillwave {

/// Solves points of a map and keeps what neighbours share. One for each thread.
class MapPoint {
  public:
    /// The study must outlive it.
    explicit MapPoint(const MapStudy& study);

    /// Puts the output at these values (SI, within the axes) into `value`, NaN where there is none. Returns
    /// why the blow could not be solved (`value` is left alone then), or an empty string. Points that differ
    /// in one parameter alone are solved faster one after the other.
    std::string solve(double x, double y, double& value, const std::stop_token& stop);

  private:
    void assign(double x, double y);
    void restoreNumbers();
    bool movesPulse(const SweepAxis& axis) const;

    const MapStudy& m_study;
    bool m_yFirst;  ///< the parameter of y is to be set before that of x
    bool m_xMovesPulse, m_yMovesPulse;
    bool m_restoresPulse;
    Scenario m_scenario;
    CaseSolver m_solver;
    double m_x = 0, m_y = 0;  // of the pulse
    bool m_hasPulse = false;
};

}  // namespace drillwave
