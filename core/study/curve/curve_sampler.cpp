// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/model/scales.h"
#include "core/study/gap/event_order.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

constexpr double lastDigits = 64 * std::numeric_limits<double>::epsilon();

/// What is smooth while it stays the same. The lattice has the events only to a step.
std::uint64_t orderOf(const Impact& impact, const Problem& problem, Method method) {
    const bool exactTimes = method != Method::lattice && problem.isForced() && impact.hasEvents();
    return exactTimes ? eventOrder(impact, problem.force()) : static_cast<std::uint64_t>(impact.contacts);
}

/// Of what blow after blow brings.
double unitPerSecond(Measure measure, const Scenario& scenario) {
    const Scales scales = scalesOf(scenario);
    const double ofBlow = measure == Measure::watt    ? scales.energy
                          : measure == Measure::speed ? scales.penetration
                                                      : scales.impulse;
    return scenario.drill.blowFrequency.value_or(1) * ofBlow;
}

}  // namespace

CurveSampler::CurveSampler(const CurveQuestion& question, const std::vector<SweepAxis>& axes,
                           std::size_t line, std::stop_token stop, long partOfLimit)
    : m_question(question),
      m_range(question.range()),
      m_stop(std::move(stop)),
      m_scenario(question.base, axes),
      m_solver(question.columns, question.method, std::max(1L, question.workLimit / partOfLimit),
               Detail::events),
      m_values(axes.size()),
      m_pulseMoves(m_scenario.movesPulse(axes.size() - 1)) {
    if (question.family) m_values.front() = question.family->value(line);
}

const Scenario& CurveSampler::scenarioAt(double share) {
    m_values.back() = m_range.at(share);
    return m_scenario.set(m_values);
}

double CurveSampler::unitAt(double share, std::size_t output) {
    const OutputColumn& column = m_question.columns[output];
    const Scenario& scenario = scenarioAt(share);
    if (m_scenario.obstacle()) return 0;
    if (column.output->isOnlySi()) return unitPerSecond(column.output->measure, scenario);
    return column.units == OutputUnits::si ? column.scale(scalesOf(scenario)) : 1;
}

const CurveSampler::Blow& CurveSampler::blowAt(double share) {
    const auto [found, isNew] = m_blows.try_emplace(share);
    Blow& blow = found->second;
    if (!isNew) return blow;
    const Scenario& scenario = scenarioAt(share);
    if (m_scenario.obstacle()) {
        blow.reason = m_scenario.obstacle()->reason;
        return blow;
    }
    if (!m_hasPulse || m_pulseMoves) m_solver.setPulse(scenario);
    m_hasPulse = true;
    blow.values.resize(m_question.columns.size());
    blow.reason = m_solver.solve(scenario, blow.values, m_stop);
    blow.lack = m_solver.lack();
    const Impact& impact = m_solver.impact();
    blow.pieces = impact.pieces;
    m_effort += impact.pieces;
    if (!blow.reason.isEmpty()) {
        blow.values.clear();
        return blow;
    }
    blow.scatter = m_solver.scatter();
    blow.contacts = impact.contacts;
    blow.order = orderOf(impact, m_solver.problem(), m_question.method.method);
    return blow;
}

FitSample CurveSampler::operator()(double share, std::size_t output) {
    const Blow& blow = blowAt(share);
    FitSample sample{.x = share, .label = blow.contacts, .effort = blow.pieces};
    sample.solved = !blow.values.empty() && std::isfinite(blow.values[output]);
    if (!sample.solved) {
        m_reason = !blow.reason.isEmpty() ? blow.reason
                   : !blow.lack.isEmpty() ? blow.lack
                                          : translatable("such a blow has too many waves to keep");
        return sample;
    }
    sample.values[0] = blow.values[output];
    // Times may be long and forces large: they are known to some of their last digits.
    sample.error = blow.scatter * unitAt(share, output) + lastDigits * std::abs(blow.values[output]);
    sample.order = blow.order;
    return sample;
}

}  // namespace drillwave
