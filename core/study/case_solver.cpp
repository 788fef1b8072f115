#include "core/study/case_solver.h"

#include <algorithm>

#include "core/study/row_text.h"

namespace drillwave {

CaseSolver::CaseSolver(std::span<const OutputColumn> columns)
    : m_columns(columns),
      m_detail(detailFor(columns)),
      m_inSi(std::ranges::any_of(columns, [](const OutputColumn& c) { return c.units == OutputUnits::si; })) {
}

bool CaseSolver::solve(const Scenario& scenario, std::string& row) {
    const Groups groups = groupsOf(scenario);
    const Impact impact = m_solver.solve(m_pulse, groups, m_detail);
    if (impact.outcome != Outcome::rebounded) {
        row.append(m_columns.size(), ',');
        return false;
    }
    const ImpactSummary summary = summarize(impact, groups);
    const Scales scales = m_inSi ? scalesOf(scenario) : Scales{};
    for (const OutputColumn& column : m_columns) {
        row += ',';
        if (const auto value = column.value(summary, scenario, scales)) appendNumber(row, *value);
    }
    return true;
}

}  // namespace drillwave
