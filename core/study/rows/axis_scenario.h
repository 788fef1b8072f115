// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario in which axes are set, to one value after another.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/model/assignments.h"
#include "core/model/scenario.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// What the axes set, each numbered as it is there.
Assignments assignmentsOf(std::span<const SweepAxis> axes);

/// Sets axes on top of a scenario. One for each thread.
class AxisScenario {
  public:
    /// Both must outlive this.
    AxisScenario(const Scenario& base, std::span<const SweepAxis> axes);

    /// The base with a value (SI) for each axis, in the order in which a scenario takes them.
    const Scenario& set(std::span<const double> values);
    /// The scenario set last.
    const Scenario& scenario() const { return m_scenario; }

    /// Whether the hammer blow may be another once the axes from this number on have other values.
    bool movesPulse(std::size_t firstChanged) const {
        return m_lastPulseAxis && firstChanged <= *m_lastPulseAxis;
    }

  private:
    void restore();

    const Scenario& m_base;
    std::span<const SweepAxis> m_axes;
    Assignments m_assignments;
    std::optional<std::size_t> m_lastPulseAxis;
    bool m_restoresPulse = false;  // some axis sets a number of the pulse
    Scenario m_scenario;
};

}  // namespace drillwave
