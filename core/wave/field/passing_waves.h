// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of waves whose histories are too long to be kept.
#pragma once

#include <cstddef>
#include <optional>

#include "core/model/pulse_force.h"
#include "core/wave/field/force_peaks.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Peaks of the impact force and largest forces in the rod, those of forcePeaks() and largestRodForces(),
/// from histories that come in parts: a force in the rod is made by waves of one round trip.
class PassingWaves {
  public:
    /// `solved` is the same impact, solved with Detail::summary or more.
    PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice);

    /// Takes what has been recorded so far but for the last round trips. Returns how many pieces there should
    /// be next time.
    std::size_t take(Impact& recording);
    /// The rest: the blow is over.
    void takeLast(Impact& recording);

    int peaks() { return m_peaks.count(); }
    const RodForces& forces() const { return m_forces; }

  private:
    void look(Impact& recording, const RodForceChoice& choice);

    PulseForce m_pulse;
    RodForceChoice m_choice;
    Impact m_window;         ///< the impact with the last part of its histories
    std::size_t m_seen = 0;  ///< pieces of it that were in the part before
    ForcePeaks m_peaks;
    RodForces m_forces;
};

}  // namespace drillwave
