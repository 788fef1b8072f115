// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/case_solver.h"

#include <algorithm>

#include "core/text/number_text.h"

namespace drillwave {

CaseSolver::CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit)
    : m_columns(columns),
      m_detail(detailFor(columns)),
      m_inSi(std::ranges::any_of(columns, [](const OutputColumn& c) { return c.units == OutputUnits::si; })),
      m_method(method),
      m_solver(workLimit) {}

std::string CaseSolver::solve(const Scenario& scenario, std::string& row, const std::stop_token& stop) {
    const Groups groups = groupsOf(scenario);
    const Impact impact = m_solver.solve(m_pulse, groups, m_detail, m_method, stop);
    if (impact.outcome != Outcome::rebounded) {
        row.append(m_columns.size(), ',');
        return impact.reason;
    }
    const ImpactSummary summary = summarize(impact, groups);
    const Scales scales = m_inSi ? scalesOf(scenario) : Scales{};
    for (const OutputColumn& column : m_columns) {
        row += ',';
        if (const auto value = column.value(summary, scenario, scales)) appendNumber(row, *value);
    }
    return {};
}

}  // namespace drillwave
