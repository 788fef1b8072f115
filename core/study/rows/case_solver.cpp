// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/case_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/blow/drill_problems.h"
#include "core/blow/impact_summary.h"
#include "core/blow/string_blow.h"
#include "core/model/blow_traits.h"
#include "core/study/drilling/drilling_numbers.h"
#include "core/wave/work_limit.h"

namespace drillwave {
namespace {

/// Work that a march may take over what its cells may: events at the bit are not foreseen.
constexpr double workWithEvents = 10;

}  // namespace

CaseSolver::CaseSolver(std::span<const OutputColumn> columns, const MethodChoice& method, long workLimit,
                       Detail least)
    : m_columns(columns),
      m_detail(std::max(least, detailFor(columns))),
      m_needsBlow(
          least > Detail::cor ||
          !std::ranges::all_of(columns, [](const OutputColumn& c) { return c.output->needsDrilling(); })),
      m_needsLess(std::ranges::any_of(columns,
                                      [](const OutputColumn& c) { return c.detail() != Detail::histories; })),
      m_inSi(std::ranges::any_of(columns, [](const OutputColumn& c) { return c.units == OutputUnits::si; })),
      m_needsMargin(
          std::ranges::any_of(columns, [](const OutputColumn& c) { return c.output->needsThrustStudy(); })),
      m_drillWishes(drillWishesFor(columns)),
      m_waveNumbers(waveNumbersFor(columns)),
      m_method(method),
      m_solver({workLimit, cellsOfPiece * workLimit}) {
    const auto takesLedger = [](const OutputColumn& column) { return column.detail() == Detail::ledger; };
    if (least < Detail::ledger && std::ranges::none_of(columns, takesLedger)) m_solver.leaveOutLedger();
}

Message CaseSolver::solve(const Scenario& scenario, std::span<double> outputs, const std::stop_token& stop) {
    assert(outputs.size() == m_columns.size());
    if (!m_needsBlow) return fill({ImpactSummary(), scenario}, outputs, stop);
    if (!isFollowedByEvents(scenario)) return solveDrillString(scenario, outputs, stop);
    setRod(m_problem, scenario);
    const auto solve = [&](Detail detail) -> const Impact& {
        m_impact = m_solver.solve(m_problem, detail, m_method, stop);
        m_scatter = m_impact.corError;
        return m_impact;
    };
    if (m_detail == Detail::histories && m_method.method == Method::exact) {
        const bool tooLong = isTooLongToKeep(solve);
        if (m_impact.outcome != Outcome::rebounded) return m_impact.reason;
        if (tooLong)
            return fillFrom(summarizeInPassing(m_impact, m_problem, m_waveNumbers, stop), scenario, outputs,
                            stop);
    }
    if (solve(m_detail).hindrance == Hindrance::histories && m_needsLess) solve(Detail::ledger);
    if (m_impact.outcome != Outcome::rebounded) return m_impact.reason;
    return fillFrom(summarizeWithWaves(m_impact, m_problem, m_waveNumbers), scenario, outputs, stop);
}

Message CaseSolver::fillFrom(const ImpactSummary& summary, const Scenario& scenario,
                             std::span<double> outputs, const std::stop_token& stop) {
    OutputSource source{summary, scenario};
    if (m_needsMargin)
        source.thrustMargin = m_margins.of(scenario, m_problem, {m_impact.cor, m_impact.corError}, stop);
    return fill(source, outputs, stop);
}

/// By one run: `efficiency_error` says how good it is.
Message CaseSolver::solveDrillString(const Scenario& scenario, std::span<double> outputs,
                                     const std::stop_token& stop) {
    NetworkSettings settings{.accuracy = NetworkAccuracy::quick, .wants = {}};
    settings.wants.forces = m_detail == Detail::histories;
    ChainSolution solution = m_solver.solveString(scenario, settings, stop);
    m_problem = std::move(solution.problem);
    m_impact = std::move(solution.impact);
    m_scatter = balanceError(m_impact);
    if (!m_impact.isSolved()) return m_impact.reason;
    ImpactSummary summary = summarize(m_impact, m_problem);
    addStresses(summary, scenario, m_impact, m_problem.pieces);
    return fill({summary, scenario}, outputs, stop);
}

Message CaseSolver::march(const Scenario& scenario, const std::stop_token& stop) {
    m_drill.reset();
    m_lack = {};
    if (!m_drillWishes.any || !drillProblem(scenario).isEmpty()) return {};
    const DrillingSettings settings = scanSettingsOf(scenario);
    const DrillingRequest wants{.cellError = m_drillWishes.penetrationError,
                                .lyapunov = m_drillWishes.lyapunov,
                                .blowAlone = false,
                                .mostWork = workWithEvents * static_cast<double>(m_solver.mostCells())};
    if (drillingWork(scenario, settings, wants) > static_cast<double>(m_solver.mostCells()))
        return WorkLimitReason::sequence;
    const DrillingResult result = studyDrilling(scenario, settings, wants, stop);
    m_drill = drillNumbersOf(result);
    m_lack = whyNoStatistics(result);
    return result.outcome == DrillingOutcome::pushedBack ? Message() : m_lack;
}

Message CaseSolver::fill(OutputSource source, std::span<double> outputs, const std::stop_token& stop) {
    if (Message problem = march(source.scenario, stop); !problem.isEmpty()) return problem;
    if (m_drill) source.drill = &*m_drill;
    const Scales scales = m_inSi ? scalesOf(source.scenario) : Scales{};
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        const std::optional<double> value = m_columns[c].value(source, scales);
        outputs[c] = value.value_or(none);
        if (!value || std::isfinite(*value)) continue;
        Message problem = overflowProblem(*m_columns[c].output, *value);
        if (problem.isEmpty()) continue;
        std::ranges::fill(outputs, none);
        return problem;
    }
    return {};
}

}  // namespace drillwave
