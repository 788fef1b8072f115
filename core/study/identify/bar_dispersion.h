// SPDX-License-Identifier: GPL-3.0-or-later
// Dispersion of the first longitudinal wave mode of a round bar.
#pragma once

#include <vector>

namespace drillwave {

/// Returns the relative phase speed c/c0, 0 … 1, of the first longitudinal (Pochhammer–Chree) mode of a round
/// bar. The argument is radius over wavelength; Poisson's ratio is 0.29 (theory of identification §2.7).
/// Constant for arguments above 1.5.
double firstModeSpeed(double radiusOverWavelength);

/// Dispersion of waves in a round bar with wave speed c0. Over a distance `way` [m], each frequency f is
/// delayed by `way`·(1/c(f) − 1/c0). A negative distance removes dispersion. The effective radius of a hollow
/// bar is √(R_o² + R_i²).
class BarDispersion {
  public:
    BarDispersion(double outerRadius, double innerRadius, double barSpeed);
    /// Returns a wave with the dispersion of the distance `way` [m], but without the travel time way/c0. The
    /// number of samples stays the same; `step` is the time between them [s].
    std::vector<double> delayed(const std::vector<double>& wave, double step, double way) const;
    /// Returns 1/c − 1/c0 [s/m], the extra delay per distance, at a frequency [Hz].
    double slowness(double frequency) const;

  private:
    double m_barSpeed;
    std::vector<double> m_frequencies, m_slownesses;
};

}  // namespace drillwave
