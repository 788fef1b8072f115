// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of waves whose histories are too long to be kept.
#pragma once

#include <cstddef>
#include <optional>

#include "core/model/pulse_force.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"

namespace drillwave {

// How often the impact force rises to a peak.

/// Counts the peaks of F above 1 % of the largest force, piece by piece in order of time. Every maximum
/// inside a smooth piece is found; two that are parted by less than 1e-9 of the largest force, which rounding
/// could do, are one.
class ForcePeaks {
  public:
    explicit ForcePeaks(double largest);
    void add(const PiecewisePolynomial& force, const PiecewisePolynomial::Piece& piece);
    /// Counts the end of the force as well, after which there may be no more pieces.
    int count();

  private:
    void pass(double force);

    double m_least, m_dip;
    double m_turn = 0;  ///< the last extremum so far
    bool m_rising = true;
    int m_peaks = 0;
};

/// Returns the number of peaks of F. Requires an impact solved with Detail::histories.
int forcePeaks(const Impact& impact);

/// Peaks of the impact force and largest forces in the rod, as by forcePeaks() and largestRodForces(), from
/// histories that arrive in parts: a force in the rod is made by waves of one round trip.
class PassingWaves {
  public:
    /// `solved` is the same impact, solved with Detail::summary or more.
    PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice);

    /// Takes everything recorded so far except the last round trips. Returns the number of pieces for the
    /// next time.
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
