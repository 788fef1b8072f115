// SPDX-License-Identifier: GPL-3.0-or-later
// Mean of the hammer force over each time step.
#pragma once

#include <cstddef>

#include "core/model/pulse_force.h"

namespace drillwave {

/// Means of the hammer force Fa/F0 over consecutive time steps [0, Δ), [Δ, 2Δ) … The sum of all means times Δ
/// is the impulse of the pulse, for any pulse and step.
class HammerCells {
  public:
    /// Creates a sequence of zeros, for a blow without a hammer force.
    HammerCells() = default;
    /// Creates the sequence of means of the hammer force `pulse`, which must outlive the object. `step` is
    /// the time step Δ > 0, in units of t0.
    HammerCells(const PulseForce& pulse, double step);

    /// Returns the mean of the hammer force over the next time step, in units of F0; 0 from the end of the
    /// pulse on.
    double next() { return m_ended ? 0.0 : nextMean(); }
    /// Returns whether the pulse is over, so that all later means are 0.
    bool ended() const { return m_ended; }

  private:
    double nextMean();
    double segmentEnd() const;

    const PulseForce* m_pulse = nullptr;
    double m_step = 1;
    /// Number of time steps taken so far; a whole number, but possibly beyond the range of int.
    double m_count = 0;
    /// Index of the segment of the pulse in which the next step begins.
    std::size_t m_segment = 0;
    bool m_ended = true;
};

}  // namespace drillwave
