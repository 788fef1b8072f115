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

/// Accuracy of a solution.
enum class NetworkAccuracy {
    quick,  ///< one run, cells cut at jumps only; error from the residual of the energy balance
    sure,  ///< cells cut at every corner of a wave, against a quick run; only the quick run if it is too much
};

/// Maximum work of one run [cells × nodes]: some seconds.
inline constexpr long mostNetworkCells = 200'000'000;

/// Settings of a run of a string on cells: accuracy, requested results, limits.
struct NetworkSettings {
    NetworkAccuracy accuracy = NetworkAccuracy::sure;
    NetworkWants wants;
    int halvings = 0;  ///< number of times that the usual cells are halved
    long mostCells = mostNetworkCells;
    bool roundsForWaves = true;  ///< waves of rounded round trips instead of none
};

/// Returns why this problem cannot be solved: losses inside the hammer, a bit mass that swings too fast.
/// Empty if it can be.
std::string_view networkRefusal(const Problem& problem);

/// Writes the cell that all round trips share into `grid`. Returns false if they share none.
bool usualGrid(const Problem& problem, CellGrid& grid);

/// Returns the possible error of the shares of E₀ of a quick run, estimated from the energy that it neither
/// kept nor lost (strings §11).
double balanceError(const Impact& impact);

/// Solves one blow after another in the same workspace: once warm, a blow of which only sums are requested,
/// and which is no larger than those before, allocates nothing. Memory for a very long string is released
/// afterwards. One solver per thread.
///
/// Where the waves of a sure run are more than can be kept, they are those of a quick one: values to
/// some 1e-3 where a wave bends within a cell, or else of a run with round trips rounded until they can
/// be kept (Impact::wavesDifference). Round trips that share no cell are rounded by up to `rounding`;
/// the error is then estimated from other cells. A blow that takes more work than permitted is not
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

/// Solves one blow by a solver of its own.
Impact solveNetwork(const Problem& problem, const NetworkSettings& settings,
                    const std::stop_token& stop = {});

}  // namespace drillwave
