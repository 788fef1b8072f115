// SPDX-License-Identifier: GPL-3.0-or-later
// A loss that hands no momentum to the surroundings: what a joint or the attenuation takes from a wave comes
// back over the time between two blows (drilling §3).
#pragma once

#include <cstddef>

#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// One place and direction, of waves x of a section with impedance Z:
///
///     out = s x + (1 − s) m,   m' = f (x − m)                                                       (D5)
///
/// Steady waves pass unchanged. (1 − s) m/f is momentum on its way, (1 − s) m²/(f Z) its energy.
class ReturnedLoss {
  public:
    ReturnedLoss() = default;
    /// s of an amplitude, 0 < s ≤ 1; f blows per t0.
    ReturnedLoss(double passing, double frequency) : m_passing(passing), m_frequency(frequency) {}

    /// Returns the wave that passes over a part of a cell of that width [t0]. The trapezoidal rule for m
    /// keeps the momentum exactly.
    WaveCell pass(const WaveCell& in, double width) {
        const double rate = m_frequency * width, before = m_mean;
        m_mean = (before * (1 - rate / 2) + rate * in.mean()) / (1 + rate / 2);
        WaveCell out = m_passing * in;
        out.c[0] += (1 - m_passing) * 0.5 * (before + m_mean);
        out.c[1] += (1 - m_passing) * 0.5 * (m_mean - before);
        m_lost += width * (in.meanSquare() - out.meanSquare()) -
                  (1 - m_passing) / m_frequency * (m_mean - before) * (m_mean + before);
        return out;
    }

    double mean() const { return m_mean; }  ///< m
    void setMean(double mean) { m_mean = mean; }
    double held() const { return (1 - m_passing) * m_mean / m_frequency; }  ///< ∫ of what is on its way back
    double square() const { return held() * m_mean; }                       ///< its energy times Z
    double lost() const { return m_lost; }                                  ///< times Z, since the beginning

  private:
    double m_passing = 1, m_frequency = 1;
    double m_mean = 0;
    double m_lost = 0;
};

}  // namespace drillwave
