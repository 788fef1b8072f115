// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/axis_scenario.h"

#include <cassert>

namespace drillwave {

Assignments assignmentsOf(const std::vector<SweepAxis>& axes) {
    Assignments assignments;
    for (const SweepAxis& axis : axes) assignments.add(axis.key());
    return assignments;
}

AxisScenario::AxisScenario(const Scenario& base, const std::vector<SweepAxis>& axes)
    : m_base(base), m_axes(axes), m_assignments(assignmentsOf(axes)), m_scenario(base) {
    for (std::size_t a = 0; a < axes.size(); ++a)
        if (m_assignments.movesPulse(a)) m_lastPulseAxis = a;
}

const Scenario& AxisScenario::set(std::span<const double> values) {
    assert(values.size() == m_axes.size());
    // What one axis sets may depend on the others in a dimensional scenario (tau moves the length, which
    // moves nothing else, but a duration moves the impulse of a given force), so that each point starts from
    // the base.
    if (m_scenario.form == ScenarioForm::dimensional) m_scenario = m_base;
    for (const std::size_t a : m_assignments.order()) m_axes[a].assign(m_scenario, values[a]);
    return m_scenario;
}

}  // namespace drillwave
