// SPDX-License-Identifier: GPL-3.0-or-later
// How often the impact force rises to a peak.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Counts the peaks of F above 1 % of the largest force, piece by piece in order of time. Every maximum
/// inside a smooth piece is found; two that are parted by less than 1e-9 of the largest force, which rounding
/// could do, are one.
class ForcePeaks {
  public:
    explicit ForcePeaks(double largest);
    void add(const PiecewisePolynomial& force, const PiecewisePolynomial::Piece& piece);
    /// With the end of the force, behind which there may be no more pieces.
    int count();

  private:
    void pass(double force);

    double m_least, m_dip;
    double m_turn = 0;  ///< the last extremum so far
    bool m_rising = true;
    int m_peaks = 0;
};

/// Of an impact solved with Detail::histories.
int forcePeaks(const Impact& impact);

}  // namespace drillwave
