// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of solutions of one blow: closed form, power series, series in long double, and lattice.
#pragma once

#include <cmath>
#include <limits>

#include "core/numeric/run_time.h"
#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/exponential_basis.h"
#include "core/wave/exact/exponential_domain.h"
#include "core/wave/exact/series_basis.h"
#include "core/wave/lattice/lattice_solver.h"
#include "tests/support/scene.h"

namespace drillwave::test {

/// Solution of a blow by one method, and its processor time [s].
struct BasisResult {
    Impact impact;
    double seconds = 0;

    bool isSolved() const { return impact.outcome == Outcome::rebounded; }
    /// Returns the absolute difference in the coefficient of restitution e; NaN if one result is not solved.
    double differenceTo(const BasisResult& other) const {
        if (!isSolved() || !other.isSolved()) return std::numeric_limits<double>::quiet_NaN();
        return std::abs(impact.cor - other.impact.cor);
    }
    /// Returns the difference in e divided by the sum of both error bounds; above 1 at least one bound is
    /// wrong.
    double excessOver(const BasisResult& other) const {
        return differenceTo(other) / (impact.corError + other.impact.corError);
    }
};

/// Solutions of one blow by several methods; those not tried count as not solved.
struct BasisFinding {
    Scene scene;
    bool isSuited = false;  ///< true if ExactSolver would try the closed form
    BasisResult closed = {}, series = {}, extended = {}, lattice = {};

    /// Returns true if two solutions differ by more than their error bounds permit.
    bool isWrong() const {
        return closed.excessOver(series) > 1 || closed.excessOver(extended) > 1 ||
               series.excessOver(extended) > 1;
    }
    /// Returns the larger Impact::growth of closed form and series; above coveredGrowth, error bounds hold in
    /// 999 of 1000 blows.
    double growth() const { return std::max(closed.impact.growth, series.impact.growth); }
};

/// Solver of a blow by each method as ExactSolver would, including its solutions of shifted inputs.
class BasisComparison {
  public:
    bool triesUnsuited = false;  ///< try the closed form even if it is not suited
    /// Limit of wave pieces in series; a blow that needs more takes too long for tests of thousands.
    long mostSeriesPieces = 50'000;
    Detail detail = Detail::cor;

    /// Returns the solutions in closed form and in series. Series in long double are added if `withTruth`, or
    /// if the two contradict each other. The lattice of 1000 segments is added if `withLattice` and the
    /// closed form succeeds.
    BasisFinding compare(const Scene& scene, bool withTruth, bool withLattice) {
        const Problem problem = problemOf(scene);
        BasisFinding finding{.scene = scene, .isSuited = suitsExponentials(problem)};
        if (finding.isSuited || triesUnsuited)
            finding.closed = solve(m_closed, problem, {.pieces = mostClosedPieces});
        finding.series = solve(m_series, problem, {.pieces = mostSeriesPieces});
        if (withTruth || finding.isWrong())
            finding.extended = solve(m_extended, problem, {.pieces = 2 * mostSeriesPieces});
        if (withLattice && finding.closed.isSolved())
            finding.lattice =
                timed([&] { return m_lattice.solve(problem, Detail::cor, {.segments = 1000}); });
        return finding;
    }

  private:
    static constexpr long mostClosedPieces = 2000;

    template <class Work>
    static BasisResult timed(const Work& work) {
        const double start = threadSeconds();
        BasisResult result{work(), 0};
        result.seconds = threadSeconds() - start;
        return result;
    }

    template <class Basis>
    BasisResult solve(ContactMarch<Basis>& march, const Problem& problem, MarchLimits limits) {
        return timed([&] {
            Impact impact;
            march.solve(problem, detail, impact, limits);
            coverGrowth(impact, [&](const InputMove& move) {
                Impact moved;
                limits.move = move;
                march.solve(problem, Detail::cor, moved, limits);
                return moved;
            });
            return impact;
        });
    }

    ContactMarch<ExponentialBasis<2>> m_closed;
    ContactMarch<SeriesBasis<double>> m_series;
    ContactMarch<SeriesBasis<long double>> m_extended;
    LatticeSolver m_lattice;
};

}  // namespace drillwave::test
