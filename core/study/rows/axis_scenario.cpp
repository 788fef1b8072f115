// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/axis_scenario.h"

#include <algorithm>
#include <cassert>

#include "core/model/blow_traits.h"
#include "core/model/pulse_force.h"
#include "core/model/validation.h"

namespace drillwave {

Assignments assignmentsOf(std::span<const SweepAxis> axes) {
    Assignments assignments;
    for (const SweepAxis& axis : axes) assignments.add(axis.key());
    return assignments;
}

void visitCorners(std::span<const SweepAxis> axes,
                  const std::function<void(std::span<const std::uint64_t>)>& visit) {
    std::vector<std::vector<std::uint64_t>> extremes;
    std::uint64_t corners = 1;
    for (const SweepAxis& axis : axes) {
        extremes.push_back(axis.extremes());
        corners *= extremes.back().size();
    }
    std::vector<std::uint64_t> point(axes.size());
    for (std::uint64_t corner = 0; corner < corners; ++corner) {
        std::uint64_t rest = corner;
        for (std::size_t a = axes.size(); a-- > 0; rest /= extremes[a].size())
            point[a] = extremes[a][rest % extremes[a].size()];
        visit(point);
    }
}

AxisScenario::AxisScenario(const Scenario& base, std::span<const SweepAxis> axes)
    : m_base(base), m_axes(axes), m_assignments(assignmentsOf(axes)), m_scenario(base) {
    const auto isPreset = [](const SweepAxis& axis) { return bool(axis.presets); };
    const bool hasShapes = std::ranges::find(axes, pulseShapeKey, &SweepAxis::key) != axes.end() ||
                           std::ranges::any_of(axes, isPreset);
    for (std::size_t a = 0; a < axes.size(); ++a) {
        if (isPreset(axes[a]))
            m_lastPulseAxis = a;
        else if (hasShapes ? m_assignments.movesPulse(a) : movesPulseForce(axes[a].key(), base.pulse.shape))
            m_lastPulseAxis = a;
        m_restoresPulse |= isPreset(axes[a]) || axes[a].key().starts_with("pulse.");
        m_changesLaw |= axes[a].key() == rockLawKey;
    }
    m_judges = hasSections(base) || hasImpossibleCorner();
}

/// Every condition on a uniform rod is a bound that moves one way with each value, so that a grid is valid
/// when its corners are: points need not be judged one by one. With the places of a string it is otherwise.
bool AxisScenario::hasImpossibleCorner() {
    bool isImpossible = false;
    std::vector<double> values(m_axes.size());
    visitCorners(m_axes, [&](std::span<const std::uint64_t> point) {
        if (isImpossible) return;
        for (std::size_t a = 0; a < values.size(); ++a) values[a] = m_axes[a].value(point[a]);
        set(values);
        isImpossible = m_obstacle.has_value();
    });
    return isImpossible;
}

const Scenario& AxisScenario::set(std::span<const double> values) {
    assert(values.size() == m_axes.size());
    // The value set by one axis may depend on the others in a dimensional scenario (tau moves the length,
    // which moves nothing else, but a duration moves the impulse of a given force), so that each point starts
    // from the base.
    if (hasUnits(m_scenario) || m_changesLaw) restore();
    m_obstacle.reset();
    for (const std::size_t a : m_assignments.order())
        if (Message problem = m_axes[a].assign(m_scenario, values[a]); !problem.isEmpty() && !m_obstacle)
            m_obstacle = {std::string(m_axes[a].key()), problem, problem, true};
    if (!m_obstacle && m_judges) m_obstacle = judge(values);
    return m_scenario;
}

std::optional<PointObstacle> AxisScenario::judge(std::span<const double> values) const {
    if (const auto pair = m_assignments.meeting(m_scenario)) {
        const std::string one(m_axes[pair->one].key()), other(m_axes[pair->other].key());
        const Message reason{translatable("%1 and %2 %3; vary one of them"), {one, other, pair->problem}};
        return PointObstacle{one, reason, reason};
    }
    if (const auto problems = validate(m_scenario); !problems.empty())
        return PointObstacle{problems.front().key, problems.front().reason, problems.front().text};
    for (std::size_t a = 0; a < m_axes.size(); ++a)
        if (const Message lost = m_axes[a].readBackProblem(m_scenario, values[a]); !lost.isEmpty()) {
            const std::string key(m_axes[a].key());
            const Message reason("%1 %2", {key, lost});
            return PointObstacle{key, reason, reason};
        }
    return std::nullopt;
}

// Not the title, and the table of the pulse only where it must be, whose owners the threads count together.
void AxisScenario::restore() {
    m_scenario.rod = m_base.rod;
    m_scenario.bitRock = m_base.bitRock;
    m_scenario.drill = m_base.drill;
    if (m_restoresPulse) m_scenario.pulse = m_base.pulse;
    m_scenario.drillString = m_base.drillString;
}

}  // namespace drillwave
