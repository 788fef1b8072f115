// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/map_point.h"

namespace drillwave {

MapPoint::MapPoint(const MapStudy& study)
    : m_study(study),
      m_yFirst(Assignments({study.x.key(), study.y.key()}).order().front() == 1),
      m_xMovesPulse(movesPulse(study.x)),
      m_yMovesPulse(movesPulse(study.y)),
      m_restoresPulse(study.x.key().starts_with("pulse.") || study.y.key().starts_with("pulse.")),
      m_scenario(study.base),
      m_solver({&study.output, 1}, study.method, study.workLimit) {}

std::string MapPoint::solve(double x, double y, double& value, const std::stop_token& stop) {
    assign(x, y);
    const bool isSamePulse = m_hasPulse && (!m_xMovesPulse || x == m_x) && (!m_yMovesPulse || y == m_y);
    if (!isSamePulse) m_solver.setPulse(m_scenario);
    m_hasPulse = true;
    m_x = x;
    m_y = y;
    return m_solver.solve(m_scenario, {&value, 1}, stop);
}

// What one axis sets may depend on the other in a scenario with units, so that each point starts from the
// base.
void MapPoint::assign(double x, double y) {
    if (m_scenario.form == ScenarioForm::dimensional) restoreNumbers();
    if (m_yFirst) m_study.y.assign(m_scenario, y);
    m_study.x.assign(m_scenario, x);
    if (!m_yFirst) m_study.y.assign(m_scenario, y);
}

// Not the title, nor the table of the pulse, whose owners the threads would count together.
void MapPoint::restoreNumbers() {
    m_scenario.rod = m_study.base.rod;
    m_scenario.bitRock = m_study.base.bitRock;
    m_scenario.drill = m_study.base.drill;
    if (m_restoresPulse) m_scenario.pulse = m_study.base.pulse;
}

bool MapPoint::movesPulse(const SweepAxis& axis) const {
    return movesPulseForce(axis.key(), m_study.base.pulse.shape);
}

}  // namespace drillwave
