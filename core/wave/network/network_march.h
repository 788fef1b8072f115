// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string, cell by cell (strings §11).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/wave/network/bit_node.h"
#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/cell_grid.h"
#include "core/wave/network/delay_line.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/joint.h"
#include "core/wave/network/network_impact.h"
#include "core/wave/network/network_problem.h"
#include "core/wave/network/node_turns.h"
#include "core/wave/network/section_watch.h"
#include "core/wave/network/string_census.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// What is wanted of a blow beside its sums.
struct NetworkWants {
    bool events = false;
    bool forces = false;           ///< of every section, and what joints reflect
    bool forcesIfTheyFit = false;  ///< a result without them rather than none
    bool histories = false;        ///< the waves of every section
    CutAt cutAt = CutAt::jumps;
    Grading grading{0.3, 1.5, 24};
};

/// What a run takes that is followed to its end and in which nothing happens.
struct ForeseenWork {
    double work = 0;  ///< in cells times nodes
    double held = 0;  ///< cells that are on their way at once
};
ForeseenWork foreseeWork(const NetworkProblem& problem, const CellGrid& grid, const NetworkWants& wants);

/// One blow on a lattice of polynomial cells. Only round trips matter: every node has a clock of its own, the
/// waves down arrive at once and those back a round trip later. A jump that a contact makes inside a cell
/// cuts every cell of every line there from then on.
class NetworkMarch {
  public:
    NetworkMarch(const NetworkProblem& problem, const CellGrid& grid, const NetworkWants& wants);

    /// At most as much work as `mostCells` cells times nodes.
    NetworkImpact run(long mostCells, const std::stop_token& stop);

  private:
    /// All that a block of steps changes beside the lines.
    struct Nodes {
        FaceNodeState face;
        BitNodeState bit;
        std::vector<double> massVelocities;
        std::size_t events;
    };
    Nodes nodes() const;
    void setNodes(const Nodes& nodes);

    /// A jump of a wave that a node makes within a step of the block.
    struct NodeJump {
        bool found = false;
        std::size_t node = 0, step = 0;
        double place = 0;  ///< in the cell, 0 … 1
    };

    void setWidths();
    void planTurns();
    void takeBlock();
    NodeJump stepBlock();
    NodeJump stepRear(const NodeTurn& turn);
    NodeJump stepJoint(std::size_t j, const NodeTurn& turn);
    NodeJump stepFace(const NodeTurn& turn);
    NodeJump stepBit(const NodeTurn& turn);
    void countFace(const WaveCell& f1, const WaveCell& b2, const CellCuts::Walk& at);
    void countBit(const WaveCell& g, const CellCuts::Walk& at);
    void countMass(std::size_t joint, const WaveCell* f1, const WaveCell* b2, const NodeTurn& turn);
    bool cut(double place);
    bool isAffordable(const CellCuts& cuts) const;
    void observe(std::size_t count);
    void keepWaves(std::size_t count);
    void scheduleCensus();
    std::optional<NetworkImpact> endOfBlow();
    bool isUntouchedSince(const CensusResult& census) const;
    bool fliesUntil(double time);
    NetworkImpact result(const CensusResult& census, NetworkEnd end);
    NetworkImpact notSolved(std::string reason) const;
    double jumpPlace(std::size_t part, double place) const;
    long flownCells() const;
    long work() const;
    long workForForces() const;
    void leaveOutForces();
    double limitTime() const;
    double clock() const { return m_cuts.clock(m_step); }

    NetworkProblem m_problem;
    CellGrid m_grid;
    NetworkWants m_wants;
    bool m_lossy;                   ///< joints or sections lose energy
    std::vector<double> m_passing;  ///< e^−αL of each section
    StringClocks m_clocks;
    CellCuts m_cuts;
    std::vector<Joint> m_joints;  ///< in front of section j + 1 at [j]; that of the face is not used
    FaceNode m_face;
    BitNode m_bit;
    std::vector<DelayLine<WaveCell>> m_lines;    ///< waves back, of each section
    std::vector<std::vector<WaveCell>> m_downs;  ///< waves down over the present block, of each section
    std::vector<NodeTurn> m_turns;               ///< who takes which steps of a block, in order
    CutAt m_cutAt = CutAt::nothing;
    std::size_t m_faceTaken = 0, m_bitTaken = 0;  ///< steps of the block whose jumps are taken as they are
    long m_step = 0;                              ///< parts of cells that every clock has gone
    long m_cells = 0;
    std::vector<ImpactEvent> m_events;
    std::optional<StringCensus> m_census;
    std::optional<CensusResult> m_free;  ///< when hammer, string and rock were apart, as they are since then
    double m_landing = 0;                ///< clock before which they are known to stay so, but no longer
    std::stop_token m_stop;
    long m_mostWork = 0;
    long m_recut = 0, m_mostRecut = 0;  ///< cells that were cut again on their way
    bool m_mayCut = true;               ///< with more parts the way that is left would be too much work
    double m_flown = 0;                 ///< cells times nodes of free flights
    std::vector<SectionWatch> m_watches;
    bool m_leftOutForces = false;
    std::vector<Joint> m_alone;        ///< the joints, met by waves down only
    std::vector<double> m_reflected;   ///< ∫b1² of those
    std::vector<WaveCell> m_weakened;  ///< waves back over the present block, as they arrive
    std::shared_ptr<StringWaves> m_waves;
    std::vector<WaveCell> m_bitForces;  ///< over the present block, where waves are kept
};

}  // namespace drillwave
