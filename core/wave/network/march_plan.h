// SPDX-License-Identifier: GPL-3.0-or-later
// Plan of the computation of a blow on a drill string: sections in whole cells, clocks, cuts and estimated
// work.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/census.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

// Order in which the nodes (ends of sections) compute the steps of a block

/// Consecutive steps of a block that one node (end of a section) computes without waiting for other nodes.
struct NodeTurn {
    /// Index of the node: node j is the rear end of section j; the index after the last section is the bit.
    std::size_t node;
    /// Index of the first time step of this turn within the block, and number of time steps of the turn.
    std::size_t from, count;
    /// Returns the index of the time step after the last one of this turn.
    std::size_t behind() const { return from + count; }
    bool operator==(const NodeTurn&) const = default;
};

/// Writes the order in which the nodes (ends of sections) compute a block of `block` time steps into `turns`.
/// A node needs the waves that the next node made a round trip earlier; `delays` are the round trips of the
/// sections in time steps, > 0. If a round trip is shorter than a block, both nodes take turns within the
/// block.
void planTurns(std::span<const std::size_t> delays, std::size_t block, std::vector<NodeTurn>& turns);

/// Requested results of a blow on a drill string. The integrals over the blow are always computed.
struct NetworkWants {
    /// Whether the times of contact events are recorded.
    bool events = false;
    /// Whether the largest forces of every section are computed.
    bool forces = false;
    /// Whether the energy reflected by each joint is computed; requires `forces`.
    bool reflections = false;
    /// Whether the largest forces may be left out if the work limit would otherwise be exceeded.
    bool forcesIfTheyFit = false;
    /// Whether the waves of every section are recorded over time.
    bool histories = false;
    /// Kinds of contact events at which all cells (time steps) are divided.
    CutAt cutAt = CutAt::jumps;
    /// Rule that divides a cell (time step) into finer parts after a cut: width of the first part, growth of
    /// the widths, maximum number of cuts.
    Grading grading{0.3, 1.5, 24};
    bool operator==(const NetworkWants&) const = default;
};

/// Estimated work of a computation that runs to its limit of time, without the work of contact events.
struct ForeseenWork {
    /// Estimated work, in cells (time steps) times nodes (ends of sections).
    double work = 0;
    /// Number of cells (waves over one time step) that are stored for all sections at one time.
    double held = 0;
};

/// Number of steps in a block, which one node (end of a section) computes before the next node; as many as
/// fit into a first-level cache.
inline constexpr std::size_t stepsOfBlock = 64;

/// Work to compute one cell (time step) and the largest forces in it, as a multiple of the work without these
/// forces.
inline constexpr long workOfForces = 8;

/// Plan for the computation of a blow: sections in whole time steps (cells), division of the time steps, and
/// estimated work. Making a plan takes no memory for waves. One plan after another can be made in the same
/// memory.
class MarchPlan {
  public:
    /// Plans the computation of a blow. `grid` gives the time step (cell) and the round trip of each section
    /// in time steps; `wants` lists the requested results.
    void begin(const Problem& problem, const CellGrid& grid, const NetworkWants& wants);

    /// Returns the problem as it is computed: round trips are rounded to whole cells (time steps). The losses
    /// given for the last section of the hammer and of the string are removed, because no joint follows.
    const Problem& problem() const { return m_problem; }
    /// Returns the number of sections of hammer and string.
    std::size_t sections() const { return m_problem.sections.size(); }
    /// Returns the size of the cells (time steps), and the round trips of the sections in cells.
    const CellGrid& grid() const { return m_grid; }
    /// Returns the requested results of the blow.
    const NetworkWants& wants() const { return m_wants; }
    /// Returns the delays of the clocks of all nodes (ends of sections). The clock of a node reads the time
    /// minus its delay.
    const StringClocks& clocks() const { return m_clocks; }
    /// Returns the division of cells (time steps) into parts at the start of the blow.
    const CellCuts& cuts() const { return m_cuts; }
    /// Returns whether joints or sections of the string take energy from the waves.
    bool isLossy() const { return m_lossy; }
    /// Returns the latest time to which the blow is computed, in units of t0: the end time, the next blow, or
    /// 40 round trips after the end of the force.
    double limitTime() const;
    /// Returns the estimated work to compute the blow, and the number of cells (waves over one time step)
    /// that it must store.
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
    /// Rate constants of all differential equations at the ends of sections, in units of 1/t0.
    std::vector<double> m_rates;
    CellCuts m_cuts;
    ForeseenWork m_foreseen;
};

}  // namespace drillwave
