// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for blows on drill strings, with a stated error (strings §11).
#pragma once

#include <memory>
#include <stop_token>
#include <string_view>

#include "core/wave/impact.h"
#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Accuracy of the solution of a blow on a drill string.
enum class NetworkAccuracy {
    /// Only one run, in which cells (time steps) are divided at jumps of waves only. The error is estimated
    /// from the energy balance.
    quick,
    /// Two runs: the quick one, and one in which cells (time steps) are divided at every bend of a wave. The
    /// error is estimated from their difference. If the second run takes too much work, only the quick run is
    /// used.
    sure,
};

/// Maximum work of one run, in cells (time steps) times nodes (ends of sections); a run of this size takes
/// some seconds.
inline constexpr long mostNetworkCells = 200'000'000;

/// Settings for the computation of a blow on a drill string: accuracy, requested results, limits.
struct NetworkSettings {
    /// Accuracy, which decides whether one or two runs are made.
    NetworkAccuracy accuracy = NetworkAccuracy::sure;
    /// Requested results besides the integrals over the blow.
    NetworkWants wants;
    /// Number of times that the default size of the cells (time steps) is halved; ≥ 0.
    int halvings = 0;
    /// Maximum work of one run, in time steps (cells) times nodes (ends of sections); a run that needs more
    /// is stopped.
    long mostCells = mostNetworkCells;
    /// Whether the waves may come from a run with larger cells and rounded round trips, if those of the
    /// accurate run are too many to be kept.
    bool roundsForWaves = true;
};

/// Returns the reason why NetworkSolver cannot solve a problem: losses inside the hammer, a bit mass that
/// oscillates too fast, or a reference case without waves. Returns an empty text if it can be solved.
std::string_view networkRefusal(const Problem& problem);

/// Writes the default time step (cell), a common divisor of all round trips, into `grid`. Returns false if no
/// common divisor is large enough; round trips must then be rounded.
bool usualGrid(const Problem& problem, CellGrid& grid);

/// Returns the estimated error of the efficiency and other shares of the hammer energy E0, from the result of
/// one run. It is 20 times the relative error of the energy balance, but at least 1e-13 (strings §11).
double balanceError(const Impact& impact);

/// Solver for blows on drill strings, which reuses its memory from blow to blow. If only integrals over the
/// blow are requested, a blow no larger than earlier ones allocates nothing. Memory for a very long string is
/// released afterwards. Each thread needs its own solver.
///
/// If the waves of the accurate run take too much memory, those of the quick run are returned. They may be
/// wrong by 1e-3 where a wave bends within a time step (cell). If those are too large as well, a run with
/// larger time steps supplies the waves (Impact::wavesDifference). If no time step divides all round trips,
/// they are rounded by up to Impact::rounding. The error is then estimated from runs with other time steps. A
/// blow that takes more work than permitted is not solved.
class NetworkSolver {
  public:
    NetworkSolver();
    ~NetworkSolver();
    NetworkSolver(NetworkSolver&&) noexcept;
    NetworkSolver& operator=(NetworkSolver&&) noexcept;

    /// Returns the solution of a blow. A stop request ends the computation within milliseconds; the blow is
    /// then not solved.
    Impact solve(const Problem& problem, const NetworkSettings& settings, const std::stop_token& stop = {});

  private:
    class Workspace;
    /// Memory for computations, allocated with the first blow.
    std::unique_ptr<Workspace> m_workspace;
};

/// Returns the solution of a blow on a drill string, computed with a temporary NetworkSolver. For many blows,
/// keep a NetworkSolver.
Impact solveNetwork(const Problem& problem, const NetworkSettings& settings,
                    const std::stop_token& stop = {});

}  // namespace drillwave
