// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/thinning_effect.h"

#include "core/blow/blow.h"
#include "core/model/blow_traits.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

/// Of the exact solver. A table has as many at least as points, most of them many times.
constexpr long mostPieces = 10'000'000;

std::optional<Impact> solved(Scenario scenario, const TablePoints& points, MethodSolver& solver,
                             const std::stop_token& stop) {
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tableFile.clear();
    scenario.pulse.tablePoints = points;
    if (!validate(scenario).empty()) return std::nullopt;
    Impact impact = solver.solve(problemOf(scenario), Detail::cor, {}, stop);
    if (!impact.isSolved()) return std::nullopt;
    return impact;
}

}  // namespace

std::optional<ThinningEffect> thinningEffect(const Scenario& scenario, const Samples& samples,
                                             const SignalRecipe& recipe, const ShapedSignal& kept,
                                             const std::stop_token& stop) {
    if (!isFollowedByEvents(scenario) || !kept.problem.empty() || kept.points.size() >= kept.samples)
        return std::nullopt;
    SignalRecipe whole = recipe;
    whole.points = mostSamplesFollowed;
    const ShapedSignal all = shapedSignal(samples, whole, stop);
    if (!all.problem.empty()) return std::nullopt;
    MethodSolver solver({.pieces = mostPieces});
    const std::optional<Impact> some = solved(scenario, kept.points, solver, stop);
    const std::optional<Impact> every = solved(scenario, all.points, solver, stop);
    if (!some || !every) return std::nullopt;
    return ThinningEffect{some->cor, some->cor - every->cor, some->corError + every->corError};
}

}  // namespace drillwave
