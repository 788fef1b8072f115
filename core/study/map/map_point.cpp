// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/map_point.h"

#include <array>

namespace drillwave {

MapPoint::MapPoint(const MapStudy& study)
    : m_axes{study.x, study.y},
      m_scenario(study.base, m_axes),
      m_solver({&study.output, 1}, study.method, study.workLimit) {}

Message MapPoint::solve(double x, double y, double& value, const std::stop_token& stop) {
    const Scenario& scenario = m_scenario.set(std::array{x, y});
    if (m_scenario.obstacle()) return m_scenario.obstacle()->reason;
    const bool xStays = x == m_x || !m_scenario.movesPulse(0), yStays = y == m_y || !m_scenario.movesPulse(1);
    if (!m_hasPulse || !xStays || !yStays) m_solver.setPulse(scenario);
    m_hasPulse = true;
    m_x = x;
    m_y = y;
    return m_solver.solve(scenario, {&value, 1}, stop);
}

}  // namespace drillwave
