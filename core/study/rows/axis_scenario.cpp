// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/axis_scenario.h"

#include <algorithm>
#include <cassert>

#include "core/model/pulse_force.h"

namespace drillwave {

Assignments assignmentsOf(std::span<const SweepAxis> axes) {
    Assignments assignments;
    for (const SweepAxis& axis : axes) assignments.add(axis.key());
    return assignments;
}

AxisScenario::AxisScenario(const Scenario& base, std::span<const SweepAxis> axes)
    : m_base(base), m_axes(axes), m_assignments(assignmentsOf(axes)), m_scenario(base) {
    const bool hasShapes = std::ranges::find(axes, pulseShapeKey, &SweepAxis::key) != axes.end();
    for (std::size_t a = 0; a < axes.size(); ++a) {
        if (hasShapes ? m_assignments.movesPulse(a) : movesPulseForce(axes[a].key(), base.pulse.shape))
            m_lastPulseAxis = a;
        m_restoresPulse |= axes[a].key().starts_with("pulse.");
    }
}

const Scenario& AxisScenario::set(std::span<const double> values) {
    assert(values.size() == m_axes.size());
    // What one axis sets may depend on the others in a dimensional scenario (tau moves the length, which
    // moves nothing else, but a duration moves the impulse of a given force), so that each point starts from
    // the base.
    if (hasUnits(m_scenario)) restore();
    for (const std::size_t a : m_assignments.order()) m_axes[a].assign(m_scenario, values[a]);
    return m_scenario;
}

// Not the title, and the table of the pulse only where it must be, whose owners the threads count together.
void AxisScenario::restore() {
    m_scenario.rod = m_base.rod;
    m_scenario.bitRock = m_base.bitRock;
    m_scenario.drill = m_base.drill;
    if (m_restoresPulse) m_scenario.pulse = m_base.pulse;
    if (isString(m_base)) m_scenario.drillString = m_base.drillString;
}

}  // namespace drillwave
