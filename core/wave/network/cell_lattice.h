// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer, string and rock on a lattice of polynomial cells (strings §11).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/wave/network/bit_node.h"
#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/census.h"
#include "core/wave/network/delay_line.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/joint.h"
#include "core/wave/network/march_plan.h"

namespace drillwave {

/// Lattice of cells in which only round trips matter: every node has its own clock, waves down arrive at once
/// and waves back a round trip later. A jump that a contact makes inside a cell cuts every cell of every line
/// there from then on. Takes blow after blow in the same memory.
class CellLattice {
  public:
    /// Starts at the first touch of hammer and string. The plan must outlive the blow; at most about
    /// `mostRecut` cells are cut while they are on their way.
    void begin(const MarchPlan& plan, long mostRecut);

    /// Takes the next block of `stepsOfBlock` steps, and gives the census the state of the nodes at its time
    /// in the block. Cells are cut where waves jump, unless the rest of the way would take more than
    /// `spareWork` cells × nodes. After a stop the block is unfinished.
    void takeBlock(StringCensus& census, double spareWork, const std::stop_token& stop);
    /// Advances to the next block.
    void advance();

    // The block that was taken last

    const CellCuts& cuts() const { return m_cuts; }
    long step() const { return m_step; }  ///< parts of cells that every clock has passed before the block
    double clock() const { return m_cuts.clock(m_step); }
    const WaveCell* down(std::size_t section) const { return m_downs.data() + section * stepsOfBlock; }
    const DelayLine<WaveCell>& line(std::size_t section) const { return m_lines[section]; }  ///< waves back
    const WaveCell* bitForces() const { return m_bitForces.data(); }  ///< where histories are wanted

    // After a block

    /// Returns the state of the hammer's face, or of the force that replaces it.
    const FaceNodeState& face() const { return m_force ? m_force->state() : m_face.state(); }
    const BitNodeState& bit() const { return m_bit.state(); }
    const std::vector<ImpactEvent>& events() const { return m_events; }  ///< where they are wanted

    double passing(std::size_t section) const { return m_passing[section]; }  ///< e^−αL
    double held() const;                                                      ///< cells on their way
    /// Returns the extra work of cells that were cut on their way, and of those with events, in cells.
    long work() const { return m_recut + workOfEvents(); }
    long workOfEvents() const;
    /// Returns why it cannot go on; empty if it can.
    std::string_view failureReason() const {
        return m_bit.failureReason().empty() ? m_face.failureReason() : m_bit.failureReason();
    }

  private:
    /// All that a block of steps changes beside the lines.
    struct Nodes {
        FaceNodeState face;
        BitNodeState bit;
        std::vector<double> massVelocities;
        std::size_t events = 0;
    };
    void keepNodes();
    void restoreNodes();

    /// A jump of a wave that a node makes within a step of the block.
    struct NodeJump {
        bool found = false;
        std::size_t node = 0, step = 0;
        double place = 0;  ///< in the cell, 0 … 1
    };

    void setWidths();
    void orderTurns();
    NodeJump stepBlock(StringCensus& census, const std::stop_token& stop);
    const WaveCell* arriving(std::size_t section, const NodeTurn& turn);
    NodeJump stepRear(const NodeTurn& turn, StringCensus& census);
    NodeJump stepJoint(const NodeTurn& turn, StringCensus& census);
    NodeJump stepFace(const NodeTurn& turn, StringCensus& census);
    NodeJump stepBit(const NodeTurn& turn, StringCensus& census, const std::stop_token& stop);
    void countFace(const WaveCell& f1, const WaveCell& b2, const CellCuts::Walk& at,
                   StringCensus& census) const;
    void countBit(const WaveCell& g, const CellCuts::Walk& at, StringCensus& census) const;
    void countMass(std::size_t joint, const WaveCell* f1, const WaveCell* b2, const NodeTurn& turn,
                   StringCensus& census);
    bool cut(double place, double spareWork);
    bool isAffordable(double time, double spareWork) const;
    double jumpPlace(std::size_t part, double place) const;
    WaveCell* toDown(std::size_t section) { return m_downs.data() + section * stepsOfBlock; }
    std::size_t faceSection() const { return m_plan->problem().hammerSections(); }

    const MarchPlan* m_plan = nullptr;
    std::size_t m_count = 0;        ///< of sections; lines and joints may be kept of more
    std::vector<double> m_passing;  ///< e^−αL of each section
    CellCuts m_cuts;
    std::vector<Joint> m_joints;  ///< in front of section j + 1 at [j]; that of the face is not used
    FaceNode m_face;
    std::optional<ForceNode> m_force;  ///< before the first section; replaces hammer and face
    BitNode m_bit;
    std::vector<DelayLine<WaveCell>> m_lines;  ///< waves back, of each section
    std::vector<WaveCell> m_downs;             ///< waves down over the block, of one section after the other
    std::vector<NodeTurn> m_turns;             ///< nodes and their steps in a block, in order
    CutAt m_cutAt = CutAt::nothing;
    std::size_t m_faceTaken = 0, m_bitTaken = 0;  ///< steps of the block whose jumps are taken as they are
    long m_step = 0;
    std::vector<ImpactEvent> m_events;
    long m_recut = 0, m_mostRecut = 0;
    bool m_mayCut = true;               ///< with more parts the way that is left would be too much work
    std::vector<WaveCell> m_weakened;   ///< waves back over the block, as they arrive
    std::vector<WaveCell> m_bitForces;  ///< over the block

    // Only for their memory
    Nodes m_before;
    CellCuts m_coarse;
    std::vector<WaveCell> m_whole;
    std::vector<std::size_t> m_delays;
};

}  // namespace drillwave
