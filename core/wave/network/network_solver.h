// SPDX-License-Identifier: GPL-3.0-or-later
// Blows on drill strings with a stated error (strings §11).
#pragma once

#include <memory>
#include <stop_token>
#include <string_view>

#include "core/wave/impact.h"
#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/problem.h"

namespace drillwave {

/// How exact an answer is wanted.
enum class NetworkAccuracy {
    quick,  ///< one run, cells cut at jumps only; its error is what the energy balance misses
    sure,  ///< cells cut at every corner of a wave, against a quick run; that alone where it is too much work
};

/// Most work of one run, in cells times nodes: some seconds.
inline constexpr long mostNetworkCells = 200'000'000;

/// What cells of this string shall divide, and how small the law of the rock asks them to be.
struct NetworkSettings {
    NetworkAccuracy accuracy = NetworkAccuracy::sure;
    NetworkWants wants;
    int halvings = 0;  ///< cells half as large as usual, and again
    long mostCells = mostNetworkCells;
    bool roundsForWaves = true;  ///< waves of rounded round trips rather than none
};

/// Why this is no problem that can be solved: losses inside the hammer, a bit mass that swings too fast.
/// Empty where it is one.
std::string_view networkRefusal(const Problem& problem);

/// Writes the cell that all round trips share into `grid`. False where they share none.
bool usualGrid(const Problem& problem, CellGrid& grid);

/// How far the shares of E₀ of a quick run may be off, as the energy it neither kept nor lost tells (strings
/// §11).
double balanceError(const Impact& impact);

/// Solves one blow after another, keeping its workspace: once warm, a blow of which nothing is wanted but
/// sums, and which is no larger than those before, allocates nothing. What a very long string took is given
/// back. One solver per thread.
///
/// Where the waves of a sure run are more than can be kept, they are those of a quick one: values to some
/// 1e-3 where a wave bends within a cell, or else of a run with round trips rounded until they can be kept
/// (Impact::wavesDifference). Round trips that share no cell are rounded: `rounding` tells by how
/// much, and the error then is what other cells make of it. A blow that takes more work than permitted is not
/// solved.
class NetworkSolver {
  public:
    NetworkSolver();
    ~NetworkSolver();
    NetworkSolver(NetworkSolver&&) noexcept;
    NetworkSolver& operator=(NetworkSolver&&) noexcept;

    /// A stop ends it within milliseconds as not solved.
    Impact solve(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop = {});

  private:
    class Workspace;
    std::unique_ptr<Workspace> m_workspace;  ///< from the first blow on
};

/// One blow by a solver of its own.
Impact solveNetwork(const Problem& problem, const NetworkSettings& settings,
                    const std::stop_token& stop = {});

}  // namespace drillwave
