// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep_check.h"

#include <algorithm>

#include "core/model/parameter_text.h"
#include "core/model/validation.h"
#include "core/study/rows/axis_scenario.h"

namespace drillwave {

namespace {

/// An axis of one would undo an axis of the other.
void checkRivals(const std::vector<SweepAxis>& axes, std::vector<std::string>& problems) {
    const Assignments assignments = assignmentsOf(axes);
    for (std::size_t a = 0; a < axes.size(); ++a)
        for (std::size_t b = a + 1; b < axes.size(); ++b)
            if (assignments.contradict(a, b))
                problems.push_back("the axes " + std::string(axes[a].key()) + " and " +
                                   std::string(axes[b].key()) + " set the same thing; vary one of them");
}

/// A parameter must have a meaning somewhere: with one of the shapes of the sweep, and once the axes before
/// it are set.
class ApplicabilityCheck {
  public:
    explicit ApplicabilityCheck(const std::vector<SweepAxis>& axes)
        : m_axes(axes), m_applied(axes.size()), m_reasons(axes.size()) {}

    void noteBeforeAssigning(std::size_t a, const Scenario& scenario) {
        m_reasons[a] = m_axes[a].parameter ? whyNotApplicable(*m_axes[a].parameter, scenario) : std::string();
        if (m_reasons[a].empty()) m_applied[a] = true;
    }

    void report(std::vector<std::string>& problems) const {
        for (std::size_t a = 0; a < m_axes.size(); ++a)
            if (!m_applied[a])
                problems.push_back("the axis " + std::string(m_axes[a].key()) +
                                   " has no meaning here: " + m_reasons[a]);
    }

  private:
    const std::vector<SweepAxis>& m_axes;
    std::vector<bool> m_applied;
    std::vector<std::string> m_reasons;
};

std::string pointText(const std::vector<SweepAxis>& axes, const std::vector<std::uint64_t>& point) {
    std::string text;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        text += (a == 0 ? "" : ", ") + std::string(axes[a].key()) + " = ";
        axes[a].column().appendText(text, axes[a].value(point[a]));
        if (axes[a].unit && !axes[a].unit->name.empty()) text += " " + std::string(axes[a].unit->name);
    }
    return text;
}

/// Calls `visit(point)` for every combination of extreme values.
template <typename Visit>
void visitCorners(const std::vector<SweepAxis>& axes, Visit visit) {
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

/// Every condition on a scenario is a bound that moves one way with each value, so that a grid is valid when
/// its corners are.
void checkCorners(const Sweep& sweep, std::vector<std::string>& problems) {
    constexpr std::size_t enough = 20;
    const Assignments assignments = assignmentsOf(sweep.axes);
    ApplicabilityCheck applicability(sweep.axes);
    std::vector<std::string> reported;  // one bad combination explains the others of the same kind
    std::string columnsProblem;
    const auto isNew = [&](std::string_view key) {
        if (problems.size() >= enough || std::ranges::find(reported, key) != reported.end()) return false;
        reported.emplace_back(key);
        return true;
    };
    visitCorners(sweep.axes, [&](const std::vector<std::uint64_t>& point) {
        Scenario scenario = sweep.base;
        for (const std::size_t a : assignments.order()) {
            applicability.noteBeforeAssigning(a, scenario);
            sweep.axes[a].assign(scenario, sweep.axes[a].value(point[a]));
        }
        columnsProblem = columnProblem(sweep.columns, scenario);
        for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
            const std::string lost = sweep.axes[a].readBackProblem(scenario, sweep.axes[a].value(point[a]));
            if (lost.empty() || !isNew(sweep.axes[a].key())) continue;
            problems.push_back("at " + pointText(sweep.axes, point) + ": " +
                               std::string(sweep.axes[a].key()) + " " + lost);
        }
        for (const InputProblem& problem : validate(scenario)) {
            if (!isNew(problem.key)) continue;
            problems.push_back("at " + pointText(sweep.axes, point) + ": " + problem.text);
        }
    });
    applicability.report(problems);
    if (!columnsProblem.empty()) problems.push_back(columnsProblem);
}

}  // namespace

std::vector<std::string> problemsOf(const Sweep& sweep) {
    std::vector<std::string> problems;
    if (sweep.axes.size() > maximumSweepAxes) {
        problems.push_back("a sweep has at most " + std::to_string(maximumSweepAxes) + " axes, this one " +
                           std::to_string(sweep.axes.size()));
        return problems;
    }
    checkRivals(sweep.axes, problems);
    if (pointCount(sweep) == 0)
        problems.push_back("the grid has more than " + std::to_string(maximumSweepPoints) +
                           " points; take fewer values");
    if (problems.empty()) checkCorners(sweep, problems);
    return problems;
}

}  // namespace drillwave
