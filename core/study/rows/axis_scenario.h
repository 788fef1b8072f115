// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario in which axes are set, to one value after another.
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

/// Returns the parameters that the axes set, numbered like the axes.
Assignments assignmentsOf(std::span<const SweepAxis> axes);

/// Calls `visit(point)` with every combination of extreme values of the axes, as indices.
void visitCorners(std::span<const SweepAxis> axes,
                  const std::function<void(std::span<const std::uint64_t>)>& visit);

/// Why a point of a study is no scenario.
struct PointObstacle {
    std::string key;         ///< that it is about; may be empty
    Message reason;          ///< "rod.bore must be less than the diameter of 38 mm", without the value
    Message text;            ///< the same with the value, if there is one
    bool isMeaning = false;  ///< an axis has no meaning there
};

/// Sets axes on top of a scenario. One object per thread.
///
/// The common rule of all studies for a valid point: every axis has a meaning there, no two set one section,
/// the scenario is valid and has the values. Otherwise the point has no result.
class AxisScenario {
  public:
    /// Requires that both outlive it.
    AxisScenario(const Scenario& base, std::span<const SweepAxis> axes);

    /// Returns the base with a value (SI) for each axis, in the order in which a scenario takes them; must
    /// not be solved if there is an obstacle().
    const Scenario& set(std::span<const double> values);
    /// The scenario set last.
    const Scenario& scenario() const { return m_scenario; }
    /// Why that is none; nothing when it is valid.
    const std::optional<PointObstacle>& obstacle() const { return m_obstacle; }

    /// Whether the hammer blow may be another once the axes from this number on have other values.
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
    bool m_restoresPulse = false;  // some axis sets a number of the pulse
    bool m_changesLaw = false;     ///< another law drops the numbers of its own
    bool m_judges = true;          // each point
    Scenario m_scenario;
    std::optional<PointObstacle> m_obstacle;
};

}  // namespace drillwave
