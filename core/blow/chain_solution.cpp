// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/chain_solution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/section_pieces.h"
#include "core/wave/network/cell_grid.h"

namespace drillwave {
namespace {

/// Of a section that is not uniform: to begin with, and at most.
constexpr int fewestOfCone = 4, mostOfCone = 128;

/// What half as many pieces may make of e and efficiency.
double wantedDifference(NetworkAccuracy accuracy) {
    return accuracy == NetworkAccuracy::quick ? 1e-4 : 1e-5;
}

struct Difference {
    double cor = 0, efficiency = 0;
    double largest() const { return std::max(cor, efficiency); }
};

Difference between(const Impact& a, const Impact& b) {
    return {std::abs(a.cor - b.cor), std::abs(a.efficiency() - b.efficiency())};
}

/// What pieces make is a third of the difference to half as many where they are fine, and more where contacts
/// differ or the difference passes through zero.
constexpr double covering = 2;
Difference larger(const Difference& now, const Difference& before) {
    return {std::max(now.cor, before.cor / 4), std::max(now.efficiency, before.efficiency / 4)};
}

/// How many pieces every section of a chain is: those of one that is not uniform begin and end on cells that
/// all sections share, or halves of them and so on, so that they cost as little as they can.
class ChainPieces {
  public:
    explicit ChainPieces(const Scenario& scenario) {
        const std::vector<const Section*> sections = allSections(scenario.drillString);
        CellGrid grid;
        if (!usualGrid(problemOf(scenario), grid)) grid.roundTrips.assign(sections.size(), 1);
        for (std::size_t j = 0; j < sections.size(); ++j) {
            m_cells.push_back(isUniform(*sections[j]) ? 0 : grid.roundTrips[j]);
            m_counts.push_back(1);
        }
    }

    const std::vector<int>& counts() const { return m_counts; }
    int largest() const { return std::ranges::max(m_counts); }

    /// At least so many times as many pieces of what is not uniform.
    void refine(int times) {
        for (std::size_t j = 0; j < m_cells.size(); ++j)
            if (m_cells[j] > 0) m_counts[j] = divisorFrom(times * m_counts[j], m_cells[j]);
    }

  private:
    /// The least divisor of `cells`, of twice as many and so on, that is `least` or some times as much: finer
    /// cells take more work in every section.
    static int divisorFrom(int least, long cells) {
        for (;; cells *= 2)
            for (int count = least; count < 5 * least; ++count)
                if (cells % count == 0) return count;
    }

    std::vector<long> m_cells;  ///< of round trips in the sections that are not uniform, 0 for the others
    std::vector<int> m_counts;
};

}  // namespace

ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop) {
    ChainSolution solution;
    const auto solve = [&](const std::vector<int>& counts, const NetworkSettings& how) {
        solution.problem = problemOf(scenario, counts);
        solution.impact = solver.solve(solution.problem, how, stop);
    };
    const std::vector<PlacedSection> placed = placedSections(scenario.drillString);
    if (std::ranges::all_of(scenario.drillString.hammer.sections, isUniform) &&
        std::ranges::all_of(placed, [](const PlacedSection& each) { return isUniform(*each.section); })) {
        solve({}, settings);
        return solution;
    }
    NetworkSettings sums = settings;
    sums.wants = {};
    ChainPieces pieces(scenario);
    pieces.refine(fewestOfCone);
    std::vector<int> counts = pieces.counts();
    solve(counts, sums);
    std::optional<Difference> left;
    while (solution.impact.isSolved() && (!left || left->largest() > wantedDifference(settings.accuracy)) &&
           2 * pieces.largest() <= mostOfCone) {
        const Impact coarse = std::move(solution.impact);
        pieces.refine(2);
        solve(pieces.counts(), sums);
        if (!solution.impact.isSolved()) break;
        const Difference now = between(solution.impact, coarse);
        // lengths that are rounded because it takes too much work are worse, however many the pieces are
        if (solution.impact.rounding > 2 * coarse.rounding) {
            if (!left) left = now;
            break;
        }
        left = left ? larger(now, *left) : now;
        counts = pieces.counts();
    }
    if (stop.stop_requested() || !left) return solution;
    solve(counts, settings);
    solution.impact.corError += covering * left->cor;
    solution.impact.efficiencyError += covering * left->efficiency;
    return solution;
}

}  // namespace drillwave
