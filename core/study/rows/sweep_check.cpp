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
        m_problems.push_back(obstacle.isMeaning ? Message(translatable("the axis %1"), {obstacle.text})
                                                : Message(translatable("at %1: %2"),
                                                          {pointText(m_axes, point), obstacle.text}));
    }

    std::vector<Message> take() { return std::move(m_problems); }

  private:
    const std::vector<SweepAxis>& m_axes;
    std::vector<std::string> m_keys;
    std::vector<Message> m_problems;
};

/// A grid must have a scenario somewhere, and that its outputs.
std::vector<Message> cornerProblems(const Sweep& sweep) {
    AxisScenario scenario(sweep.base, sweep.axes);
    ImpossibleCorners impossible(sweep.axes);
    bool isPossible = false;
    Message ofColumns;
    std::vector<double> values(sweep.axes.size());
    visitCorners(sweep.axes, [&](std::span<const std::uint64_t> point) {
        for (std::size_t a = 0; a < values.size(); ++a) values[a] = sweep.axes[a].value(point[a]);
        scenario.set(values);
        if (scenario.obstacle()) return impossible.add(point, *scenario.obstacle());
        isPossible = true;
        ofColumns = columnProblem(sweep.columns, scenario.scenario());
    });
    if (!isPossible) return impossible.take();
    return ofColumns.isEmpty() ? std::vector<Message>() : std::vector{ofColumns};
}

}  // namespace

std::vector<Message> problemsOf(const Sweep& sweep) {
    std::vector<Message> problems;
    const auto add = [&](const char* pattern, std::vector<Message> places) {
        problems.emplace_back(pattern, std::move(places));
    };
    if (sweep.axes.empty() || sweep.columns.empty()) {
        add(translatable("a sweep needs at least one axis and one output"), {});
        return problems;
    }
    if (sweep.axes.size() > maximumSweepAxes) {
        add(translatable("a sweep has at most %1 axes, this one %2"),
            {std::to_string(maximumSweepAxes), std::to_string(sweep.axes.size())});
        return problems;
    }
    if (const auto pair = assignmentsOf(sweep.axes).rivals())
        add(translatable("the axes %1 and %2 %3; vary one of them"),
            {std::string(sweep.axes[pair->one].key()), std::string(sweep.axes[pair->other].key()),
             pair->problem});
    if (pointCount(sweep) == 0)
        add(translatable("the grid has more than %1 points; take fewer values"),
            {std::to_string(maximumSweepPoints)});
    return problems.empty() ? cornerProblems(sweep) : problems;
}

}  // namespace drillwave
