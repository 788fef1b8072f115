// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/thinned_blow.h"

#include <algorithm>
#include <cmath>

#include "core/blow/blow.h"
#include "core/model/blow_traits.h"
#include "core/model/form_conversion.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

/// Limit of wave pieces for the exact solver. Most tables have as many as points, or several times as many.
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

constexpr std::size_t fewestPoints = 12;
constexpr double moreByStep = 1.4;  // points from try to try

/// Wave pieces of the exact solver for one try.
constexpr long mostPiecesOfTry = 10'000'000;

/// The rod on which e is compared; nothing where there is none, as without units.
std::optional<Scenario> comparedRod(const Scenario& scenario) {
    if (!hasSections(scenario)) return scenario;
    Scenario rod = uniformRodOf(scenario).scenario;
    rod.bitRock.gap = 0;
    return rod;
}

std::optional<double> corOf(Scenario rod, const TablePoints& points, MethodSolver& solver,
                            const std::stop_token& stop) {
    rod.pulse = {};
    rod.pulse.shape = PulseShape::table;
    rod.pulse.tablePoints = points;
    if (!validate(rod).empty()) return std::nullopt;
    const Impact impact = solver.solve(problemOf(rod), Detail::cor, {}, stop);
    return impact.isSolved() ? std::optional(impact.cor) : std::nullopt;
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

ThinnedBlow thinnedBlow(const Scenario& scenario, const Samples& samples, const SignalRecipe& recipe,
                        const std::stop_token& stop) {
    SignalRecipe whole = recipe;
    whole.points = mostSamplesFollowed;
    ThinnedBlow blow{shapedSignal(samples, whole, stop), 0, {}, false};
    if (!blow.signal.problem.empty()) return blow;
    const double impulse = blow.signal.impulse;
    MethodSolver solver({.pieces = mostPiecesOfTry});
    const std::optional<Scenario> rod = comparedRod(scenario);
    const std::optional<double> found = rod ? corOf(*rod, blow.signal.points, solver, stop) : std::nullopt;
    const bool hasCor = found.has_value();
    const double cor = found.value_or(0);
    const std::size_t all = std::min(blow.signal.points.size(), recipe.points);
    for (double points = fewestPoints; points < static_cast<double>(all) && !stop.stop_requested();
         points = std::ceil(points * moreByStep)) {
        whole.points = static_cast<std::size_t>(points);
        ShapedSignal tried = shapedSignal(samples, whole, stop);
        if (!tried.problem.empty()) continue;
        const double change = std::abs(tried.impulse - impulse) / impulse;
        if (!(change <= thinningError)) continue;
        std::optional<double> corChange;
        if (hasCor) {
            const std::optional<double> now = corOf(*rod, tried.points, solver, stop);
            if (!now || std::abs(*now - cor) > thinningError) continue;
            corChange = *now - cor;
        }
        return {std::move(tried), change, corChange, true};
    }
    if (recipe.points >= blow.signal.points.size()) return blow;
    whole.points = recipe.points;
    blow.signal = shapedSignal(samples, whole, stop);
    blow.impulseChange = std::abs(blow.signal.impulse - impulse) / impulse;
    blow.isThinned = blow.signal.points.size() < blow.signal.samples;
    return blow;
}

}  // namespace drillwave
