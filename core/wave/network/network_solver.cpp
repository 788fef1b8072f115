// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/network_solver.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

/// How smooth waves have to be in the cells: cells in which a wave of the elastic line changes by more are
/// halved, and parts behind a front are as fine as that.
struct Smoothness {
    double mostChange;
    Grading grading;
    CutAt cutAt;
};
constexpr Smoothness quickSmoothness{0.2, {0.3, 1.5, 24}, CutAt::jumps};
constexpr Smoothness sureSmoothness{0.02, {0.15, 1.25, 100}, CutAt::corners};

/// Round trips of hammer and string are at most so many cells; what shares none is rounded to that.
constexpr double mostSharedCells = 2e6;
constexpr double roundedCells = 2e4;

/// Of the work that is permitted, as much may be foreseen for one run.
constexpr double sharedShare = 0.5, roundedShare = 0.1;

/// A bit mass may swing so often in the round trip of all sections.
constexpr double mostSwings = 1e6;

/// Cells on their way at once: some hundreds of megabytes.
constexpr double mostHeld = 4e6;

/// What rounding in double precision is worth, in E0.
constexpr double leastError = 1e-13;

/// The difference of two solutions counts as often: it covered all that was tried.
constexpr double covering = 4;

/// The energy balance of a quick run misses an error of the efficiency by up to 14 times where the faces have
/// a stiffness, by 5 on very soft rock; elsewhere it is far larger.
constexpr double coveringResidual = 20;

double roundTripOf(const NetworkProblem& problem) {
    double sum = 0;
    for (const NetworkSection& section : problem.sections) sum += 2 * section.transitTime;
    return sum;
}

/// Halves cells until the waves that the rock makes are smooth in them, as far as that is worth the work.
CellGrid fineEnough(CellGrid grid, const NetworkProblem& problem, double mostChange) {
    constexpr double enoughCells = 4000;  // to all round trips: beyond it the parts behind fronts must do
    const NetworkSection& last = problem.sections.back();
    const double rate = problem.law.beta / problem.law.gamma / last.impedance;
    const double roundTrip = roundTripOf(problem);
    while (rate * grid.cell > mostChange && roundTrip / grid.cell < enoughCells) grid = grid.halved();
    return grid;
}

NetworkWants wantsOf(const NetworkSettings& settings, const Smoothness& smoothness) {
    NetworkWants wants = settings.wants;
    wants.cutAt = smoothness.cutAt;
    wants.grading = smoothness.grading;
    wants.forcesIfTheyFit = smoothness.cutAt == CutAt::jumps;  // else there is a quick run that has them
    return wants;
}

NetworkImpact solveOn(const NetworkProblem& problem, const CellGrid& grid, const NetworkSettings& settings,
                      const Smoothness& smoothness, const std::stop_token& stop) {
    return NetworkMarch(problem, grid, wantsOf(settings, smoothness)).run(settings.mostCells, stop);
}

double restitution(const NetworkImpact& impact) {
    return impact.faceImpulse > 0 ? -impact.stringMomentum / impact.faceImpulse : 0;
}

/// What its energy balance misses is what a run alone can tell of its error; `share` of it counts.
void stateError(NetworkImpact& impact, double share) {
    const double missed = share * std::abs(impact.energyResidual);
    impact.efficiencyError = std::max({leastError, impact.efficiencyError, missed});
    impact.corError = std::max({leastError, impact.corError, missed});
}

/// And what another run makes of it.
void stateError(NetworkImpact& impact, const NetworkImpact& other) {
    stateError(impact, 1);
    const auto widen = [](double& error, double difference) {
        error = std::max(error, covering * std::abs(difference));
    };
    widen(impact.efficiencyError, impact.energy.rock - other.energy.rock);
    widen(impact.corError, restitution(impact) - restitution(other));
}

/// Round trips that share no cell: rounded, and rounded otherwise.
NetworkImpact solveRounded(const NetworkProblem& problem, const NetworkSettings& settings,
                           const std::stop_token& stop) {
    double cell = roundTripOf(problem) / roundedCells;
    const CellGrid finest = roundedGrid(problem.sections, cell);
    const double foreseen = foreseeWork(problem, finest, wantsOf(settings, quickSmoothness)).work;
    cell *= std::max(1.0, foreseen / roundedShare / static_cast<double>(settings.mostCells));
    NetworkImpact impact =
        solveOn(problem, roundedGrid(problem.sections, cell), settings, quickSmoothness, stop);
    NetworkSettings sums = settings;
    sums.wants = {};
    for (const double other : {0.83, 1.19}) {
        if (impact.end == NetworkEnd::notSolved) return impact;
        const NetworkImpact compared =
            solveOn(problem, roundedGrid(problem.sections, other * cell), sums, quickSmoothness, stop);
        if (compared.end == NetworkEnd::notSolved) return compared;
        stateError(impact, compared);
    }
    return impact;
}

}  // namespace

std::string_view networkRefusal(const NetworkProblem& problem) {
    for (std::size_t j = 0; j < problem.hammerSections; ++j)
        if (problem.sections[j].decay > 0 || (j + 1 < problem.hammerSections && problem.sections[j].loss > 0))
            return "losses inside the hammer are not part of the model: give loss and attenuation to the "
                   "string only";
    const double mass = problem.sections.back().massAfter;
    if (mass > 0) {
        const double slope = problem.law.beta / problem.law.gamma;
        const OscillationRates rates{problem.sections.back().impedance, mass, slope};
        if (rates.fastest() * roundTripOf(problem) > mostSwings)
            return "the bit mass swings too fast on this rock to be followed: leave it out, it is too small "
                   "to matter, or give a softer rock";
    }
    return {};
}

std::optional<CellGrid> usualGrid(const NetworkProblem& problem) {
    return sharedGrid(problem.sections, roundTripOf(problem) / mostSharedCells);
}

NetworkImpact solveNetwork(const NetworkProblem& problem, const NetworkSettings& settings,
                           const std::stop_token& stop) {
    if (const std::string_view refusal = networkRefusal(problem); !refusal.empty()) {
        NetworkImpact refused;
        refused.reason = refusal;
        return refused;
    }
    std::optional<CellGrid> grid = usualGrid(problem);
    if (!grid) return solveRounded(problem, settings, stop);
    const auto gridFor = [&](const Smoothness& smoothness) {
        CellGrid fitting = fineEnough(*grid, problem, smoothness.mostChange);
        for (int i = 0; i < settings.halvings; ++i) fitting = fitting.halved();
        return fitting;
    };
    const CellGrid quickGrid = gridFor(quickSmoothness);
    const ForeseenWork foreseen = foreseeWork(problem, quickGrid, wantsOf(settings, quickSmoothness));
    if (foreseen.work > sharedShare * static_cast<double>(settings.mostCells) || foreseen.held > mostHeld)
        return solveRounded(problem, settings, stop);
    NetworkImpact quick = solveOn(problem, quickGrid, settings, quickSmoothness, stop);
    if (quick.end == NetworkEnd::notSolved) return quick;
    stateError(quick, coveringResidual);
    if (settings.accuracy == NetworkAccuracy::quick) return quick;
    const CellGrid sureGrid = gridFor(sureSmoothness);
    if (foreseeWork(problem, sureGrid, wantsOf(settings, sureSmoothness)).held > mostHeld) return quick;
    NetworkImpact sure = solveOn(problem, sureGrid, settings, sureSmoothness, stop);
    if (sure.end == NetworkEnd::notSolved) return stop.stop_requested() ? sure : quick;
    if (!sure.waves) sure.waves = quick.waves;
    stateError(sure, quick);
    sure.cells += quick.cells;
    return sure;
}

}  // namespace drillwave
