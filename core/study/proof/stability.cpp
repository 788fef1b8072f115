// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/stability.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/contact/contact_law.h"
#include "core/numeric/ordered_work.h"
#include "core/text/units.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/lattice/lattice_solver.h"

namespace drillwave {
namespace {

constexpr StabilityMarks marks = stabilityMarks;
constexpr long mostRecorded = 200'000;  // pieces of which histories are kept
constexpr long mostExtended = 5000;     // pieces of blows that are solved again in long double
constexpr int latticeSegments = 2000;

void require(StabilityRow& row, bool holds, const char* what, double value) {
    if (!holds) row.failures.push_back({what, {formatNumber(value)}});
}

/// The momentum that the rock took and the one that the waves carry were summed apart; so were the energies.
void checkBalances(StabilityRow& row, const Impact& impact) {
    row.momentumResidual = 1 - impact.impulse - impact.finalMomentum;
    require(row, std::abs(row.momentumResidual) <= marks.momentum, translatable("momentum residual %1"),
            row.momentumResidual);
    row.energyResidual = impact.energyResidual();
    require(row, std::abs(row.energyResidual) <= marks.energy, translatable("energy residual %1"),
            row.energyResidual);
}

double leastForceOf(const Impact& impact) {
    double least = 0;
    for (const auto& piece : impact.force.pieces())
        for (int k = 0; k <= 8; ++k) least = std::min(least, impact.force.value(piece, piece.length * k / 8));
    return impact.peakForce > 0 ? least / impact.peakForce : least;
}

/// How far the free front end gets beyond the point of the last separation over the round trip after it.
double reachOf(const Impact& impact) {
    const auto pieces = impact.incident.pieces();
    const auto forces = impact.force.pieces();
    std::size_t first = pieces.size();
    while (first > 0 && forces[first - 1].count == 0) --first;  // free flight to the end of the recording
    double position = 0, reach = 0;
    for (std::size_t i = first; i < pieces.size(); ++i) {
        for (int k = 1; k <= 8; ++k)
            reach =
                std::max(reach, position + 2 * impact.incident.integral(pieces[i], pieces[i].length * k / 8));
        position += 2 * impact.incident.integral(pieces[i], pieces[i].length);
    }
    return reach;
}

void checkHistories(StabilityRow& row, const Problem& problem, ExactSolver& solver,
                    const std::stop_token& stop) {
    if (row.pieces > mostRecorded) return;
    const Impact impact = solver.solve(problem, Detail::histories, stop);
    row.leastForce = leastForceOf(impact);
    require(row, *row.leastForce >= -marks.pull, translatable("tension on the rock: F/Fmax %1"),
            *row.leastForce);
    row.reach = reachOf(impact);
    require(row, *row.reach <= marks.reach && impact.finalMomentum <= marks.momentum,
            translatable("not at its end: the bit returns by %1"), *row.reach);
}

constexpr double near = 1e-10;  // how far off neighbours are

/// The stated error covers input moved by 16 roundings: what hangs on the last digits hangs more on
/// neighbours, if not in proportion.
double changeMark(const StabilityRow& row) {
    constexpr double movedBy = 16 * std::numeric_limits<double>::epsilon();
    return marks.change + 10 * row.corError * near / movedBy;
}

void checkContinuity(StabilityRow& row, const Problem& problem, ExactSolver& solver,
                     const std::stop_token& stop) {
    std::array<Problem, 4> neighbours{problem, problem, problem, problem};
    neighbours[0].law.beta *= 1 + near;
    neighbours[1].law.gamma *= 1 - near;
    neighbours[2].sections[0].transitTime *= 1 + near;
    neighbours[3].gap += near;
    for (const Problem& neighbour : neighbours) {
        const Impact impact = solver.solve(neighbour, Detail::cor, stop);
        const double change =
            impact.outcome == Outcome::rebounded ? std::abs(impact.cor - row.cor) : INFINITY;
        row.change = std::max(row.change, change);
    }
    require(row, row.change <= changeMark(row), translatable("not continuous: e changes by %1"), row.change);
}

/// Rigid rock: e → 1 once the blow ends before it returns. Soft rock, reference case: e → √γ.
void checkLimits(StabilityRow& row, const Problem& problem) {
    const Groups& g = row.stabilityCase.groups;
    if (g.beta >= 1e5 && problem.force().end <= 2 * g.tau)
        row.limitDistance = std::abs(row.cor - 1) * std::sqrt(g.beta) / 10;
    if (problem.force().isRigidBody() && g.beta * g.tau <= 1e-3)
        row.limitDistance =
            std::abs(row.cor - std::sqrt(g.gamma)) / (10 * std::sqrt(g.beta * g.tau / g.gamma));
    if (row.limitDistance)
        require(row, *row.limitDistance <= marks.limit, translatable("far from its limit by a factor %1"),
                *row.limitDistance);
}

/// The lattice shares no code with the exact solver; it is asked where its steps resolve the contact.
void checkLattice(StabilityRow& row, const Problem& problem, LatticeSolver& lattice,
                  const std::stop_token& stop) {
    const Groups& g = row.stabilityCase.groups;
    const double step = g.tau / latticeSegments;
    const bool resolved = ContactLaw<>(problem.law).slopes().elastic * step < 0.05 && step < 0.01 &&
                          problem.force().end < 20 * g.tau;
    if (!resolved || g.beta * g.tau < 1e-3 || g.delta > 100) return;
    const Impact impact = lattice.solve(problem, Detail::cor, {.segments = latticeSegments}, stop);
    if (impact.outcome != Outcome::rebounded || !(impact.corError > 0)) return;
    row.latticeDistance = std::abs(impact.cor - row.cor) / (impact.corError + row.corError);
    require(row, *row.latticeDistance <= marks.lattice,
            translatable("the lattice differs, in units of its error estimate: %1"), *row.latticeDistance);
}

/// The stated error, against more digits, which have an error of their own.
void checkBound(StabilityRow& row, const Problem& problem, const std::stop_token& stop) {
    if (row.pieces > mostExtended) return;
    const Impact extended = solveInExtendedPrecision(problem, Detail::cor, stop);
    if (extended.outcome != Outcome::rebounded) return;
    row.boundDistance = std::abs(extended.cor - row.cor) / (row.corError + extended.corError);
    require(row, *row.boundDistance <= marks.bound,
            translatable("the error bound is exceeded by a factor of %1"), *row.boundDistance);
}

StabilityRow check(const StabilityCase& stabilityCase, ExactSolver& solver, LatticeSolver& lattice,
                   const std::stop_token& stop) {
    StabilityRow row;
    row.stabilityCase = stabilityCase;
    const Problem problem = problemOf(stabilityCase);
    const auto start = std::chrono::steady_clock::now();
    const Impact impact = solver.solve(problem, Detail::ledger, stop);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.outcome = impact.outcome;
    row.reason = impact.reason;
    row.pieces = impact.pieces;
    if (impact.outcome != Outcome::rebounded) return row;
    row.cor = impact.cor;
    row.corError = impact.corError;
    checkBalances(row, impact);
    checkHistories(row, problem, solver, stop);
    checkContinuity(row, problem, solver, stop);
    checkLimits(row, problem);
    checkLattice(row, problem, lattice, stop);
    checkBound(row, problem, stop);
    return row;
}

}  // namespace

StabilityWorst worstOf(const StabilityRow& row) {
    if (row.outcome != Outcome::rebounded) return {"not solved", INFINITY};
    StabilityWorst worst{"momentum", std::abs(row.momentumResidual) / marks.momentum};
    const auto consider = [&](std::string_view measure, std::optional<double> value, double mark) {
        if (value && *value / mark > worst.ratio) worst = {measure, *value / mark};
    };
    consider("energy", std::abs(row.energyResidual), marks.energy);
    if (row.leastForce) consider("pull", -*row.leastForce, marks.pull);
    consider("return", row.reach, marks.reach);
    consider("continuity", row.change, changeMark(row));
    consider("limit", row.limitDistance, marks.limit);
    consider("lattice", row.latticeDistance, marks.lattice);
    consider("stated error", row.boundDistance, marks.bound);
    return worst;
}

std::size_t StabilityReport::notSolved() const {
    return static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [](const StabilityRow& row) { return row.outcome != Outcome::rebounded; }));
}

std::size_t StabilityReport::failed() const {
    return static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [](const StabilityRow& row) { return !row.failures.empty(); }));
}

StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const StabilityProgress& progress) {
    struct Chunk {
        std::size_t index = 0;
        StabilityRow row;
    };
    StabilityReport report;
    std::size_t next = 0;
    const auto fill = [&](Chunk& chunk) {
        chunk.index = next;
        return next++ < cases.size();
    };
    const auto makeWorker = [&cases] {
        return [&cases, solver = ExactSolver(), lattice = LatticeSolver()](
                   Chunk& chunk, const std::stop_token& token) mutable {
            chunk.row = check(cases[chunk.index], solver, lattice, token);
        };
    };
    const auto deliver = [&](Chunk& chunk) {
        report.rows.push_back(std::move(chunk.row));
        if (progress) progress(report);
        return true;
    };
    report.stopped = processInOrder<Chunk>(jobs, stop, fill, makeWorker, deliver) == WorkEnd::stopped;
    return report;
}

}  // namespace drillwave
