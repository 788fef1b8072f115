// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/lattice/lattice_solver.h"

#include <cmath>
#include <vector>

#include "core/text/message.h"
#include "core/wave/lattice/comparison_lattices.h"
#include "core/wave/lattice/lattice_march.h"
#include "core/wave/lattice/segment_waves.h"

namespace drillwave {

struct LatticeSolver::Workspace {
    LatticeMarch<MovedWaves> moved;
    LatticeMarch<RingWaves> ring;
};

LatticeSolver::LatticeSolver() : m_workspace(std::make_unique<Workspace>()) {}
LatticeSolver::~LatticeSolver() = default;
LatticeSolver::LatticeSolver(LatticeSolver&&) noexcept = default;
LatticeSolver& LatticeSolver::operator=(LatticeSolver&&) noexcept = default;

namespace {

/// As many times more segments than `segments` as `other` has fewer.
int finerInsteadOf(int other, int segments) {
    return static_cast<int>(std::ceil(double(segments) / other * segments));
}

/// How far lattices differ: max − min of the restitutions of this one and the others; NaN when some cannot be
/// solved, not even with as many times more segments as they had fewer.
template <class SolveCor>
double spread(double cor, int segments, const std::vector<int>& others, SolveCor solveCor) {
    double least = cor, most = cor;
    for (const int other : others) {
        double result = solveCor(other);
        if (std::isnan(result)) result = solveCor(finerInsteadOf(other, segments));
        if (std::isnan(result)) return result;
        least = std::fmin(least, result);
        most = std::fmax(most, result);
    }
    return most - least;
}

}  // namespace

Impact LatticeSolver::solve(const Problem& problem, Detail detail, const LatticeOptions& options,
                            const std::stop_token& stop) {
    Impact impact;
    impact.reason = Message::ofTable(rodRefusal(problem));
    if (!impact.reason.isEmpty()) return impact;
    auto& [moved, ring] = *m_workspace;
    if (options.waves == LatticeWaves::moved)
        moved.solve(problem, options.segments, detail, stop, impact);
    else
        ring.solve(problem, options.segments, detail, stop, impact);
    impact.corError = std::nan("");
    if (impact.outcome != Outcome::rebounded || options.estimate == ErrorEstimate::none) return impact;

    const auto corOf = [&](int segments) {
        Impact other;
        ring.solve(problem, segments, Detail::cor, stop, other);
        return other.outcome == Outcome::rebounded ? other.cor : std::nan("");
    };
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * (1 + std::sqrt(impact.pieces));
    const std::vector<int> others = comparisonLattices(problem, options.segments);
    impact.corError = 2 * spread(impact.cor, options.segments, others, corOf) + rounding;
    if (std::isnan(impact.corError)) {
        impact.outcome = Outcome::notSolved;
        impact.reason =
            stop.stop_requested()
                ? "stopped"
                : translatable(
                      "lattices of other step lengths find no solution, so that its error cannot be "
                      "estimated; use more segments or the exact method");
    }
    return impact;
}

}  // namespace drillwave
