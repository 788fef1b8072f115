// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for hammer, string and rock with polynomial cells (strings §11).
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

/// Computation of one blow in cells (time steps) with a cubic polynomial for each wave. Every node (end of a
/// section) has its own clock, delayed by the travel time from the hammer face. On these clocks, waves
/// towards the rock arrive at once, waves away from it a round trip later. If a contact makes a wave jump
/// inside a cell, all cells are divided at that point from then on. One blow after another can be computed in
/// the same memory.
class CellLattice {
  public:
    /// Starts a blow at the time when hammer and string first touch. The plan must outlive the blow.
    /// `mostRecut` limits the work of dividing time steps (cells) at jumps: no more are divided once about
    /// this many stored cells were rewritten.
    void begin(const MarchPlan& plan, long mostRecut);

    /// Computes the next block of `stepsOfBlock` time steps. If the time of `census` is in this block, the
    /// state of bit, hammer face and joints at that time is written to it. Time steps (cells) are divided
    /// where waves jump, unless the rest of the blow would then take more than `spareWork` (time steps ×
    /// nodes). After a stop request the block is unfinished.
    void takeBlock(StringCensus& census, double spareWork, const std::stop_token& stop);
    /// Moves on by one block: the waves of the computed block enter the sections, and takeBlock() then
    /// computes the next block.
    void advance();

    // Functions for the last computed block

    /// Returns the present division of cells (time steps) into parts.
    const CellCuts& cuts() const { return m_cuts; }
    /// Returns the number of time steps (parts of cells) before the last computed block. It is the same on
    /// the clocks of all nodes (ends of sections).
    long step() const { return m_step; }
    /// Returns the clock reading at the start of the last computed block, in units of t0. It is the same on
    /// the clocks of all nodes (ends of sections).
    double clock() const { return m_cuts.clock(m_step); }
    /// Returns the waves towards the rock that enter a section at its rear end, in units of F0: one for each
    /// time step of the block.
    const WaveCell* down(std::size_t section) const { return m_downs.data() + section * stepsOfBlock; }
    /// Returns the waves away from the rock inside a section, in units of F0, as a queue of time steps.
    const DelayLine<WaveCell>& line(std::size_t section) const { return m_lines[section]; }
    /// Returns the impact force at each time step of the current block, in units of F0; valid only if
    /// histories are requested.
    const WaveCell* bitForces() const { return m_bitForces.data(); }

    // Functions for the state after the last computed block

    /// Returns the state of the hammer face, or of the prescribed force that replaces the hammer.
    const FaceNodeState& face() const { return m_force ? m_force->state() : m_face.state(); }
    /// Returns the state of bit and rock.
    const BitNodeState& bit() const { return m_bit.state(); }
    /// Returns the contact events of bit and rock so far; empty unless requested.
    const std::vector<ImpactEvent>& events() const { return m_events; }

    /// Returns the factor e^−αL by which a section reduces the amplitude of a wave over one transit.
    double passing(std::size_t section) const { return m_passing[section]; }
    /// Returns the number of cells (waves over one time step) that are stored for all sections at one time.
    double held() const;
    /// Returns the extra work so far, in units of the work of one cell (time step): for dividing the waves
    /// within sections, and for contact events.
    long work() const { return m_recut + workOfEvents(); }
    /// Returns the work for contact events so far, in units of the work of a cell (time step) without events.
    long workOfEvents() const;
    /// Returns the reason why the computation failed; empty if it did not.
    std::string_view failureReason() const {
        return m_bit.failureReason().empty() ? m_face.failureReason() : m_bit.failureReason();
    }

  private:
    /// State of all nodes (ends of sections) at the start of a block of time steps. It is kept to repeat the
    /// block if cells are divided. The waves within sections are not included.
    struct Nodes {
        FaceNodeState face;
        BitNodeState bit;
        std::vector<double> massVelocities;
        std::size_t events = 0;
    };
    void keepNodes();
    void restoreNodes();

    /// Event at the hammer face or the bit within a time step, at which all cells (time steps) should be
    /// divided.
    struct NodeJump {
        bool found = false;
        std::size_t node = 0, step = 0;
        /// Position of the jump as a fraction of the cell (time step), 0 … 1.
        double place = 0;
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
    /// Number of sections in use; m_lines and m_joints may be longer.
    std::size_t m_count = 0;
    /// Factor e^−αL by which each section reduces the amplitude of a wave over one transit.
    std::vector<double> m_passing;
    CellCuts m_cuts;
    /// Joints of neighbouring sections: m_joints[j] is between the sections j and j + 1. The joint at the
    /// hammer face is not used.
    std::vector<Joint> m_joints;
    FaceNode m_face;
    /// Prescribed force on the rear end of the first section; empty if a hammer strikes the string.
    std::optional<ForceNode> m_force;
    BitNode m_bit;
    /// Waves away from the rock inside each section, as queues with the length of one round trip.
    std::vector<DelayLine<WaveCell>> m_lines;
    /// Waves towards the rock that enter each section during the block: `stepsOfBlock` cells (time steps) for
    /// one section after the other.
    std::vector<WaveCell> m_downs;
    /// Order of computation in a block: nodes (ends of sections) and the steps of each.
    std::vector<NodeTurn> m_turns;
    CutAt m_cutAt = CutAt::nothing;
    /// Number of leading time steps of the block in which events at the hammer face, or at the bit, no longer
    /// divide the cells. They are set because a division there was refused.
    std::size_t m_faceTaken = 0, m_bitTaken = 0;
    long m_step = 0;
    std::vector<ImpactEvent> m_events;
    long m_recut = 0, m_mostRecut = 0;
    /// Whether cells (time steps) may still be cut; false once the rest of the blow would take too much work
    /// with more parts.
    bool m_mayCut = true;
    /// Waves away from the rock over the block after attenuation, as they arrive at the rear end of a
    /// section.
    std::vector<WaveCell> m_weakened;
    /// Impact force at each time step of the current block, in units of F0.
    std::vector<WaveCell> m_bitForces;

    // Temporary data; these are members only to reuse their memory
    Nodes m_before;
    CellCuts m_coarse;
    std::vector<WaveCell> m_whole;
    std::vector<std::size_t> m_delays;
};

}  // namespace drillwave
