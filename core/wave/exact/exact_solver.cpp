// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/text/message.h"
#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/exponential_basis.h"
#include "core/wave/exact/exponential_domain.h"
#include "core/wave/exact/series_basis.h"
#include "core/wave/exact/soft_reference.h"

namespace drillwave {

struct ExactSolver::Workspace {
    ContactMarch<ExponentialBasis<2>> closed;
    ContactMarch<ExponentialBasis<2 + mostCornersOfSums>> closedOfCorners;
    ContactMarch<SeriesBasis<double>> series;

    void march(const Problem& problem, Detail detail, const MarchLimits& limits, Impact& impact);
    [[gnu::cold]] void coverGrowthOf(Impact& impact, const Problem& problem, MarchLimits limits);
};

namespace {

/// A blow that needs more exponential pieces than this is one for power series.
constexpr long mostClosedPieces = mostPiecesKept;

/// Where the error of the closed form may be more than this, terms have cancelled: series keep the digits.
constexpr double mostClosedError = 3e-13;

bool isSolved(const Impact& impact) {
    return impact.outcome == Outcome::rebounded;
}

/// Marks an impact as not solved if a number is infinite by overflow; numbers not requested may be NaN.
void refuseOverflow(Impact& impact) {
    const auto isBeyond = [](double number) { return std::isinf(number); };
    const double numbers[]{impact.peakForce,       impact.firstContactTime, impact.separationTime,
                           impact.contactDuration, impact.hammerWork,       impact.rockWork,
                           impact.finalEnergy};
    if (std::isfinite(impact.cor + impact.corError) && std::ranges::none_of(numbers, isBeyond)) return;
    impact.outcome = Outcome::notSolved;
    impact.reason = translatable("its numbers are beyond the range of double precision");
}

}  // namespace

/// Marches once into a new `impact`: in closed form if that suits and reaches its end, else in series.
void ExactSolver::Workspace::march(const Problem& problem, Detail detail, const MarchLimits& limits,
                                   Impact& impact) {
    if (suitsExponentials(problem)) {
        MarchLimits few = limits;
        few.pieces = std::min(limits.pieces, mostClosedPieces);
        few.error = mostClosedError;
        const bool isDecided = problem.law.corners.empty()
                                   ? closed.solve(problem, detail, impact, few)
                                   : closedOfCorners.solve(problem, detail, impact, few);
        if (isDecided && isSolved(impact) && impact.corError <= mostClosedError) return;
        const long abandoned = impact.pieces;
        impact = Impact{};
        impact.abandoned = abandoned;
    }
    series.solve(problem, detail, impact, limits);
}

void ExactSolver::Workspace::coverGrowthOf(Impact& impact, const Problem& problem, MarchLimits limits) {
    coverGrowth(impact, [&](const InputMove& move) {
        limits.move = move;
        Impact moved;
        march(problem, Detail::cor, limits, moved);
        return moved;
    });
}

ExactSolver::ExactSolver(long mostPieces)
    : m_workspace(std::make_unique<Workspace>()), m_mostPieces(mostPieces) {}
ExactSolver::~ExactSolver() = default;
ExactSolver::ExactSolver(ExactSolver&&) noexcept = default;
ExactSolver& ExactSolver::operator=(ExactSolver&&) noexcept = default;

Impact ExactSolver::solve(const Problem& problem, Detail detail, const std::stop_token& stop) {
    Impact impact;  // the only one returned: a move of it would be seen in sweeps
    if (const std::string_view refusal = rodRefusal(problem); !refusal.empty()) {
        impact.reason = Message::ofTable(refusal);
        return impact;
    }
    if (problem.force().isRigidBody() && isSoftReference(problem)) {
        impact = softReference(problem, detail);
        refuseOverflow(impact);
        return impact;
    }
    m_workspace->march(problem, detail, {.pieces = m_mostPieces, .stop = &stop, .ledger = m_ledger}, impact);
    if (!isSolved(impact)) return impact;
    impact.corError += roundingOfHammer(problem.force());
    if (impact.growth > 1) m_workspace->coverGrowthOf(impact, problem, {m_mostPieces, &stop});
    refuseOverflow(impact);
    return impact;
}

Impact marchInPassing(const Problem& problem, long pieces, const HandOver& handOver,
                      const std::stop_token& stop) {
    MarchLimits limits;
    limits.pieces = pieces + 1;
    limits.stop = &stop;
    limits.handOver = &handOver;
    limits.ledger = false;
    Impact impact;
    std::make_unique<ContactMarch<SeriesBasis<double>>>()->solve(problem, Detail::histories, impact, limits);
    return impact;
}

Impact solveInExtendedPrecision(const Problem& problem, Detail detail, const std::stop_token& stop) {
    const auto march = std::make_unique<ContactMarch<SeriesBasis<long double>>>();
    const auto solve = [&](Detail wanted, const InputMove& move) {
        Impact impact;
        march->solve(problem, wanted, impact, {.stop = &stop, .move = move});
        return impact;
    };
    Impact impact = solve(detail, {});
    impact.corError += roundingOfHammer(problem.force());
    coverGrowth(impact, [&](const InputMove& move) { return solve(Detail::cor, move); });
    return impact;
}

}  // namespace drillwave
