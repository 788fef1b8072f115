// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep_check.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/study/rows/axis_scenario.h"

namespace drillwave {

namespace {

std::string pointText(const std::vector<SweepAxis>& axes, std::span<const std::uint64_t> point) {
    std::string text;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        text += (a == 0 ? "" : ", ") + std::string(axes[a].key()) + " = ";
        axes[a].column().appendText(text, axes[a].value(point[a]));
        if (axes[a].unit && !axes[a].unit->name.empty()) text += " " + std::string(axes[a].unit->name);
    }
    return text;
}

/// All corners of a grid without a single scenario: what is wrong with them. The grid is not tried then.
class ImpossibleCorners {
  public:
    explicit ImpossibleCorners(const std::vector<SweepAxis>& axes) : m_axes(axes) {}

    void add(std::span<const std::uint64_t> point, const PointObstacle& obstacle) {
        constexpr std::size_t enough = 20;
        // one bad combination explains the others of the same kind
        if (m_problems.size() >= enough || std::ranges::find(m_keys, obstacle.key) != m_keys.end()) return;
        m_keys.push_back(obstacle.key);
        m_problems.push_back((obstacle.isMeaning ? "the axis " : "at " + pointText(m_axes, point) + ": ") +
                             obstacle.text);
    }

    std::vector<std::string> take() { return std::move(m_problems); }

  private:
    const std::vector<SweepAxis>& m_axes;
    std::vector<std::string> m_keys, m_problems;
};

/// A grid must have a scenario somewhere, and that its outputs.
std::vector<std::string> cornerProblems(const Sweep& sweep) {
    AxisScenario scenario(sweep.base, sweep.axes);
    ImpossibleCorners impossible(sweep.axes);
    bool isPossible = false;
    std::string ofColumns;
    std::vector<double> values(sweep.axes.size());
    visitCorners(sweep.axes, [&](std::span<const std::uint64_t> point) {
        for (std::size_t a = 0; a < values.size(); ++a) values[a] = sweep.axes[a].value(point[a]);
        scenario.set(values);
        if (scenario.obstacle()) return impossible.add(point, *scenario.obstacle());
        isPossible = true;
        ofColumns = columnProblem(sweep.columns, scenario.scenario());
    });
    if (!isPossible) return impossible.take();
    return ofColumns.empty() ? std::vector<std::string>() : std::vector{ofColumns};
}

}  // namespace

std::vector<std::string> problemsOf(const Sweep& sweep) {
    std::vector<std::string> problems;
    if (sweep.axes.size() > maximumSweepAxes) {
        problems.push_back("a sweep has at most " + std::to_string(maximumSweepAxes) + " axes, this one " +
                           std::to_string(sweep.axes.size()));
        return problems;
    }
    if (const auto pair = assignmentsOf(sweep.axes).rivals())
        problems.push_back("the axes " + std::string(sweep.axes[pair->one].key()) + " and " +
                           std::string(sweep.axes[pair->other].key()) + " " + pair->problem +
                           "; vary one of them");
    if (pointCount(sweep) == 0)
        problems.push_back("the grid has more than " + std::to_string(maximumSweepPoints) +
                           " points; take fewer values");
    return problems.empty() ? cornerProblems(sweep) : problems;
}

}  // namespace drillwave
