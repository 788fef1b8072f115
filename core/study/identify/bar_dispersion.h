// SPDX-License-Identifier: GPL-3.0-or-later
// Dispersion of the first longitudinal mode of a round bar.
#pragma once

#include <vector>

namespace drillwave {

/// c/c0 of the first Pochhammer–Chree mode at a radius over the wavelength, ν = 0.29 (theory of
/// identification §2.7); constant beyond 1.5.
double firstModeSpeed(double radiusOverWavelength);

/// Delays every frequency of a wave by `way`·(1/c(f) − 1/c0): what dispersion adds on that way, or takes off
/// where it is negative. A bored bar counts with √(R_o² + R_i²) as its radius. Keeps the number of samples.
class BarDispersion {
  public:
    BarDispersion(double outerRadius, double innerRadius, double barSpeed);
    /// Samples `step` apart [s].
    std::vector<double> delayed(const std::vector<double>& wave, double step, double way) const;
    /// 1/c − 1/c0 at a frequency [s/m].
    double slowness(double frequency) const;

  private:
    double m_barSpeed;
    std::vector<double> m_frequencies, m_slownesses;
};

}  // namespace drillwave
