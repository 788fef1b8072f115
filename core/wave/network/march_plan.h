// SPDX-License-Identifier: GPL-3.0-or-later
// Plan of a blow before it is followed: the string on its cells, its clocks, its cuts, its work.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/census.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

// In which order the nodes of a string take the steps of a block.

/// Steps of a block that a node takes without waiting for others.
struct NodeTurn {
    std::size_t node;  ///< before section `node`; after the last one the bit
    std::size_t from, count;
    std::size_t behind() const { return from + count; }
    bool operator==(const NodeTurn&) const = default;
};

/// Writes the order of the nodes into `turns`. A node waits for the waves that the next one made `delays`
/// steps before, a round trip of each section, > 0. Where that is less than a block, both nodes take turns.
void planTurns(std::span<const std::size_t> delays, std::size_t block, std::vector<NodeTurn>& turns);

/// Requested results of a blow besides its sums.
struct NetworkWants {
    bool events = false;
    bool forces = false;           ///< the largest of every section
    bool reflections = false;      ///< with the forces: reflections at joints
    bool forcesIfTheyFit = false;  ///< omits them, if too much work, to get a result
    bool histories = false;        ///< the waves of every section
    CutAt cutAt = CutAt::jumps;
    Grading grading{0.3, 1.5, 24};
    bool operator==(const NetworkWants&) const = default;
};

/// Estimated work of a run that is followed to its end without events.
struct ForeseenWork {
    double work = 0;  ///< [cells × nodes]
    double held = 0;  ///< number of cells on their way at once
};

/// Steps taken by one node before the next one follows: as many as fit into a first-level cache.
inline constexpr std::size_t stepsOfBlock = 64;

/// Work of a cell for its largest forces, in cells.
inline constexpr long workOfForces = 8;

/// Plans one blow after another in the same memory; uses no memory for waves.
class MarchPlan {
  public:
    void begin(const Problem& problem, const CellGrid& grid, const NetworkWants& wants);

    /// Returns the string as its cells have it: round trips are whole cells, and there is no joint after the
    /// last section of hammer or string.
    const Problem& problem() const { return m_problem; }
    std::size_t sections() const { return m_problem.sections.size(); }
    const CellGrid& grid() const { return m_grid; }
    const NetworkWants& wants() const { return m_wants; }
    const StringClocks& clocks() const { return m_clocks; }
    const CellCuts& cuts() const { return m_cuts; }  ///< at the beginning
    bool isLossy() const { return m_lossy; }         ///< joints or sections lose energy
    /// Returns the time to which the blow is followed at most [t0].
    double limitTime() const;
    const ForeseenWork& foreseen() const { return m_foreseen; }

  private:
    void takeRates();
    void cutAtFronts(const PulseForce& force);
    void foresee();

    Problem m_problem;
    CellGrid m_grid;
    NetworkWants m_wants;
    bool m_lossy = false;
    std::vector<double> m_transitTimes;
    StringClocks m_clocks;
    std::vector<double> m_rates;  ///< at which something follows in this string [1/t0]
    CellCuts m_cuts;
    ForeseenWork m_foreseen;
};

}  // namespace drillwave
