// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario in which the parameters of several axes are set, to one combination of values after another.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/model/assignments.h"
#include "core/model/scenario.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// Returns the parameters that the axes set, in the order of the axes.
Assignments assignmentsOf(std::span<const SweepAxis> axes);

/// Calls `visit(point)` for every corner of the grid of the axes: every combination of the smallest and
/// largest values, and of all words and presets. `point` has the index of the value on each axis.
void visitCorners(std::span<const SweepAxis> axes,
                  const std::function<void(std::span<const std::uint64_t>)>& visit);

/// Reason why a combination of axis values is not a valid scenario.
struct PointObstacle {
    std::string key;  ///< key of the parameter that the reason is about; may be empty
    /// Reason without the axis value that caused it, such as "rod.bore must be less than the diameter of 38
    /// mm". The member `text` includes this value.
    Message reason;
    Message text;  ///< reason including the value that caused it, if there is one
    /// Whether the axis cannot set its value at all, for example because its parameter does not apply to the
    /// scenario. False if the value was set but makes the scenario invalid.
    bool isMeaning = false;
};

/// Scenario at a point of a grid: the values of several axes are set on top of a base scenario. All studies
/// use it, so that they agree on which points are valid. Every axis must apply to the scenario, and no two
/// axes may set the same section. The scenario must be valid and contain the values as set. Points that are
/// not valid have no result. Each thread needs its own object.
class AxisScenario {
  public:
    /// Stores references to both arguments, which must outlive this object.
    AxisScenario(const Scenario& base, std::span<const SweepAxis> axes);

    /// Returns the base scenario with one value (SI) set for each axis. The values are set in the order that
    /// the scenario requires. If obstacle() is set afterwards, the scenario is invalid and must not be
    /// solved.
    const Scenario& set(std::span<const double> values);
    /// Returns the scenario from the last call of set().
    const Scenario& scenario() const { return m_scenario; }
    /// Returns why the scenario from the last call of set() is invalid; empty if it is valid.
    const std::optional<PointObstacle>& obstacle() const { return m_obstacle; }

    /// Returns whether the hammer force may change if only the axes from index `firstChanged` on take other
    /// values. If not, the caller can keep the hammer force of the previous point.
    bool movesPulse(std::size_t firstChanged) const {
        return m_lastPulseAxis && firstChanged <= *m_lastPulseAxis;
    }

  private:
    void restore();
    bool hasImpossibleCorner();
    std::optional<PointObstacle> judge(std::span<const double> values) const;

    const Scenario& m_base;
    std::span<const SweepAxis> m_axes;
    Assignments m_assignments;
    std::optional<std::size_t> m_lastPulseAxis;
    bool m_restoresPulse = false;  // whether an axis sets a parameter of the hammer force
    /// Whether an axis changes the rock law. Each point then starts from the base scenario, because a new law
    /// drops the parameters of the previous one.
    bool m_changesLaw = false;
    bool m_judges = true;  // whether each point is checked
    Scenario m_scenario;
    std::optional<PointObstacle> m_obstacle;
};

}  // namespace drillwave
