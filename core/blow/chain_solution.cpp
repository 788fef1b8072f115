// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/chain_solution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/section_pieces.h"
#include "core/wave/network/cell_cuts.h"

namespace drillwave {
namespace {

/// Pieces of a section that is not uniform: at first, and at most.
constexpr int fewestOfCone = 2, mostOfCone = 128;

/// Trials that are compared at least, whatever work is permitted, and those before no more pieces are tried:
/// where contacts differ, one difference may be small by chance.
constexpr std::size_t fewestTrials = 3, wantedTrials = 4;

/// Difference of e and efficiency to half as many pieces at which no more pieces are tried.
double wantedDifference(NetworkAccuracy accuracy) {
    return accuracy == NetworkAccuracy::quick ? 1e-4 : 1e-5;
}

/// Twice as many pieces take up to four times the work. They are tried if that is at most this share of the
/// permitted work.
constexpr double workOfDoubling = 4;
double shareOfTrial(NetworkAccuracy accuracy) {
    return accuracy == NetworkAccuracy::quick ? 0.05 : 0.25;
}

/// Absolute differences of two results.
struct Difference {
    double cor = 0, efficiency = 0;
    double largest() const { return std::max(cor, efficiency); }
};

Difference between(const Impact& a, const Impact& b) {
    return {std::abs(a.cor - b.cor), std::abs(a.efficiency() - b.efficiency())};
}

/// Numbers of pieces of every section, and what a blow without waves makes of them.
struct Trial {
    std::vector<int> counts;
    Impact sums;
};

/// Returns whether lengths were rounded to save work, which is worse than fewer pieces.
bool isRoundedMore(const Impact& impact, const Impact& than) {
    return impact.isRounded() && impact.rounding > 2 * than.rounding;
}

/// Stated error of the last of some trials, for each of its differences to the one before; those of earlier
/// trials fall with the square of the pieces.
constexpr double covering = 2, falling = 4;

/// Least error of e as a share of that of the efficiency: pieces are what both come from.
constexpr double leastShareOfCor = 0.5;

/// Returns what the pieces of the last trial are off by at most. Requires two trials or more.
Difference errorOfPieces(const std::vector<Trial>& trials) {
    constexpr std::size_t differences = 3;
    Difference error;
    double weight = covering;
    for (std::size_t i = trials.size() - 1; i > 0 && i + differences >= trials.size(); --i) {
        const Difference one = between(trials[i].sums, trials[i - 1].sums);
        error.cor = std::max(error.cor, weight * one.cor);
        error.efficiency = std::max(error.efficiency, weight * one.efficiency);
        weight /= falling;
    }
    error.cor = std::max(error.cor, leastShareOfCor * error.efficiency);
    return error;
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

/// Adds the waves of fewer pieces where those of the solution are more than can be kept, and of rounded round
/// trips where no number of pieces has any.
void addCoarseWaves(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                    const std::vector<Trial>& trials, ChainSolution& solution, const std::stop_token& stop) {
    NetworkSettings waves = settings;
    waves.accuracy = NetworkAccuracy::quick;
    waves.wants = {.histories = true};
    for (auto trial = trials.rbegin(); trial != trials.rend() && !solution.impact.waves; ++trial) {
        waves.roundsForWaves = settings.roundsForWaves && trial + 1 == trials.rend();
        const Impact coarser = solver.solve(problemOf(scenario, trial->counts), waves, stop);
        if (stop.stop_requested()) return;
        if (!coarser.isSolved() || !coarser.waves) continue;
        solution.impact.takeWavesOf(coarser);
        solution.impact.incident = coarser.incident;
        solution.impact.force = coarser.force;
    }
}

}  // namespace

ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop) {
    ChainSolution solution;
    const auto solve = [&](const std::vector<int>& counts, const NetworkSettings& how) {
        solution.problem = problemOf(scenario, counts);
        solution.impact = solver.solve(solution.problem, how, stop);
        return solution.impact.isSolved();
    };
    if (hasUniformSections(scenario.drillString)) {
        solve({}, settings);
        return solution;
    }
    NetworkSettings sums = settings;
    sums.wants = {};
    const double wanted = wantedDifference(settings.accuracy);
    const double mostWork = shareOfTrial(settings.accuracy) * static_cast<double>(settings.mostCells);
    std::vector<Trial> trials;
    ChainPieces pieces(scenario);
    pieces.refine(fewestOfCone);
    while (solve(pieces.counts(), sums)) {
        if (!trials.empty() && isRoundedMore(solution.impact, trials.front().sums)) break;
        trials.push_back({pieces.counts(), solution.impact});
        if (trials.size() >= wantedTrials &&
            between(trials.back().sums, trials[trials.size() - 2].sums).largest() <= wanted)
            break;
        if (2 * pieces.largest() > mostOfCone) break;
        if (trials.size() >= fewestTrials &&
            workOfDoubling * static_cast<double>(solution.impact.pieces) > mostWork)
            break;
        pieces.refine(2);
    }
    if (stop.stop_requested() || trials.empty()) return solution;
    if (trials.size() == 1) {
        ChainPieces fewer(scenario);
        fewer.refine(fewestOfCone / 2);
        if (!solve(fewer.counts(), sums)) return solution;
        trials.insert(trials.begin(), {fewer.counts(), solution.impact});
    }
    const Difference error = errorOfPieces(trials);
    const Impact& finest = trials.back().sums;
    const auto widen = [&] {
        const Difference here = between(solution.impact, finest);
        solution.impact.corError += error.cor + here.cor;
        solution.impact.efficiencyError += error.efficiency + here.efficiency;
    };
    if (settings.wants == sums.wants) {
        solution = {problemOf(scenario, trials.back().counts), finest};
        widen();
        return solution;
    }
    NetworkSettings full = settings;
    full.roundsForWaves = false;  // fewer pieces do less harm
    for (auto trial = trials.rbegin(); trial != trials.rend(); ++trial) {
        // The forces or waves of so many pieces may take too much work.
        const bool isLast = trial + 1 == trials.rend();
        if (!solve(trial->counts, full) || (!isLast && isRoundedMore(solution.impact, trial->sums))) {
            if (stop.stop_requested()) break;
            continue;
        }
        widen();
        if (settings.wants.histories) addCoarseWaves(scenario, settings, solver, trials, solution, stop);
        break;
    }
    return solution;
}

}  // namespace drillwave
