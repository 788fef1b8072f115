// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer force as the lattice sees it: its mean over each step.
#pragma once

#include <cstddef>

#include "core/model/pulse_force.h"

namespace drillwave {

/// Means of Fa/F0 over [0, Δ), [Δ, 2Δ) …, one after the other. For any pulse and step, the steps together
/// have the impulse of the pulse.
class HammerCells {
  public:
    /// Has no force.
    HammerCells() = default;
    /// `pulse` must outlive the cells; `step` is Δ in t0, > 0.
    HammerCells(const PulseForce& pulse, double step);

    /// The mean over the next step; 0 from the end of the pulse on.
    double next() { return m_ended ? 0.0 : nextMean(); }
    /// Returns whether all later steps are 0.
    bool ended() const { return m_ended; }

  private:
    double nextMean();
    double segmentEnd() const;

    const PulseForce* m_pulse = nullptr;
    double m_step = 1;
    double m_count = 0;         ///< steps taken: whole, and beyond the range of int for long pulses
    std::size_t m_segment = 0;  ///< the one in which the next step begins
    bool m_ended = true;
};

}  // namespace drillwave
