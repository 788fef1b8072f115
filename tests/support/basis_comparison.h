// SPDX-License-Identifier: GPL-3.0-or-later
// One blow in closed form, in series, in long double and by the lattice, compared.
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

/// Result of one representation for a blow, and its processor time [s].
struct BasisResult {
    Impact impact;
    double seconds = 0;

    bool isSolved() const { return impact.outcome == Outcome::rebounded; }
    /// Difference in e; NaN where one of the two is not solved.
    double differenceTo(const BasisResult& other) const {
        if (!isSolved() || !other.isSolved()) return std::numeric_limits<double>::quiet_NaN();
        return std::abs(impact.cor - other.impact.cor);
    }
    /// The difference in units of the sum of both bounds: above 1, one of them does not hold.
    double excessOver(const BasisResult& other) const {
        return differenceTo(other) / (impact.corError + other.impact.corError);
    }
};

/// One blow, compared. Representations that were not tried are not solved.
struct BasisFinding {
    Scene scene;
    bool isSuited = false;  ///< ExactSolver would try the closed basis
    BasisResult closed = {}, series = {}, extended = {}, lattice = {};

    /// Whether two results contradict each other's bounds.
    bool isWrong() const {
        return closed.excessOver(series) > 1 || closed.excessOver(extended) > 1 ||
               series.excessOver(extended) > 1;
    }
    /// The larger Impact::growth: above coveredGrowth, bounds hold in 999 of 1000 blows.
    double growth() const { return std::max(closed.impact.growth, series.impact.growth); }
};

/// Solves with each basis as ExactSolver would, moved inputs included.
class BasisComparison {
  public:
    bool triesUnsuited = false;      ///< try the closed basis even where it is not suited
    long mostSeriesPieces = 50'000;  ///< beyond, a scene takes too long for thousands
    Detail detail = Detail::cor;

    /// Always in closed form and in series; `withTruth`, and where these differ, in long double;
    /// `withLattice` by the lattice of 1000 segments, where the closed basis solves.
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
