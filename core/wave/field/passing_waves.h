// SPDX-License-Identifier: GPL-3.0-or-later
// Number of force peaks, and largest forces in a rod, for blows whose histories are too long to be kept.
#pragma once

#include <cstddef>
#include <optional>

#include "core/model/pulse_force.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

// Counting of the peaks of the impact force.

/// Counter of the peaks of the impact force that exceed 1 % of the largest force. Pieces of the force are
/// added in order of time; every maximum inside a smooth piece is found. Two peaks count as one if the dip
/// between them is less than 1e-9 of the largest force, as rounding can make such dips.
class ForcePeaks {
  public:
    /// Creates a counter for a force whose largest value is `largest`, in units of F0.
    explicit ForcePeaks(double largest);
    /// Adds the next piece of the impact force, in order of time.
    void add(const PiecewisePolynomial& force, const PiecewisePolynomial::Piece& piece);
    /// Returns the number of peaks. If the force still rises at its end, this end is a peak, too. Call it
    /// last: no pieces may be added afterwards.
    int count();

  private:
    void pass(double force);

    double m_least, m_dip;
    double m_turn = 0;  ///< last maximum or minimum of the force so far, in units of F0
    bool m_rising = true;
    int m_peaks = 0;
};

/// Returns the number of peaks of the impact force above 1 % of the largest force. Requires an impact solved
/// with Detail::histories.
int forcePeaks(const Impact& impact);

/// Number of peaks of the impact force and largest forces in the rod, computed while the histories arrive in
/// parts. The results are those of forcePeaks() and largestRodForces(). Only the last two round trips of the
/// histories are kept, since a force in the rod depends on the waves of one round trip.
class PassingWaves {
  public:
    /// Creates the object for a blow that is computed a second time. `solved` is the result of the first
    /// computation, with Detail::summary or more; `pulse` is the hammer force. `choice` selects the forces to
    /// find.
    PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice);

    /// Processes the histories recorded so far, and then removes all but their last two round trips from
    /// `recording`. Returns the number of pieces in `recording` at which the solver has to call it again.
    std::size_t take(Impact& recording);
    /// Processes the last part of the histories, which take() has not seen, after the blow has ended.
    void takeLast(Impact& recording);

    /// Returns the number of peaks of the impact force; call it once, after takeLast().
    int peaks() { return m_peaks.count(); }
    /// Returns the largest forces in the rod that have been found so far, in units of F0.
    const RodForces& forces() const { return m_forces; }

  private:
    void look(Impact& recording, const RodForceChoice& choice);

    PulseForce m_pulse;
    RodForceChoice m_choice;
    Impact m_window;         ///< impact with the last part of its histories
    std::size_t m_seen = 0;  ///< number of pieces of m_window already processed
    ForcePeaks m_peaks;
    RodForces m_forces;
};

}  // namespace drillwave
