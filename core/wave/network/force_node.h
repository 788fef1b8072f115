// SPDX-License-Identifier: GPL-3.0-or-later
// A force on the rear end of a string, which does not feel what comes back (strings §4).
#pragma once

#include "core/model/pulse_force.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// The rear end of a string of impedance Z under the force Fa: f = Fa − b, and it moves at v = (f − b)/Z.
/// Once the force is over, it is a face from which a hammer has parted for ever.
class ForceNode {
  public:
    /// `force` must outlive it.
    ForceNode(const PulseForce& force, double impedance) : m_force(&force), m_impedance(impedance) {}

    /// The wave that leaves over a cell of this width that begins at `time` [t0], while `back` arrives.
    WaveCell step(const WaveCell& back, double time, double width);

    const FaceNodeState& state() const { return m_now; }  ///< its record is that of Fa
    void setState(const FaceNodeState& state) { m_now = state; }

  private:
    const PulseForce* m_force;
    double m_impedance;
    FaceNodeState m_now;
};

}  // namespace drillwave
