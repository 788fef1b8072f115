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
    /// Creates a counter for an impact force whose largest value is `largest`, in units of F0. Peaks below 1
    /// % of it are not counted.
    explicit ForcePeaks(double largest);
    /// Adds the next piece of the impact force, in order of time.
    void add(const PiecewisePolynomial& force, const PiecewisePolynomial::Piece& piece);
    /// Returns the number of peaks of the force. A force that still rises when it ends has its last peak at
    /// this end. Call it last: no pieces may be added afterwards.
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

/// Search for the peaks of the impact force and the largest forces in the rod, while the solver computes the
/// histories part by part. It gives the results of forcePeaks() and largestRodForces() for histories too long
/// to be kept. It keeps only their last two round trips, since a force in the rod depends on the waves of one
/// round trip.
class PassingWaves {
  public:
    /// Creates the object for a blow that is computed a second time. `solved` is the result of the first
    /// computation, with Detail::summary or more; `pulse` is the hammer force. `choice` selects the forces to
    /// find.
    PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice);

    /// Processes the histories recorded so far, and then removes all but their last two round trips from
    /// `recording`. Returns a number of pieces: the solver must call take() again when `recording` contains
    /// so many.
    std::size_t take(Impact& recording);
    /// Processes the last part of the histories after the blow has ended, which take() has not yet processed.
    void takeLast(Impact& recording);

    /// Returns the number of peaks of the impact force; call it once, after takeLast().
    int peaks() { return m_peaks.count(); }
    /// Returns the largest forces in the rod up to the time processed so far, in units of F0.
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
