// SPDX-License-Identifier: GPL-3.0-or-later
// Noise of a gauge before the front, as an autoregressive model that draws more of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace drillwave {

/// n_i = Σ a_j n_(i−j) + e_i, e normal; below the lowest frequency that the quiet stretch shows, noise of
/// density 1/f joins it.
class GaugeNoise {
  public:
    GaugeNoise() = default;
    /// Fits the samples before the front, `step` apart [s]; their mean is taken off. The deviation is at
    /// least `least` > 0.
    GaugeNoise(std::span<const double> quiet, double step, double least);

    double deviation() const { return m_deviation; }  ///< of a sample
    /// Long-run deviation of a sample: σ_e/(1 − Σa).
    double longRun() const { return m_longRun; }
    /// Deviation that this model gives to means over `span` samples.
    double deviationOfMean(std::size_t span) const;

    /// Draws `count` samples of which the mean over the first `quiet` is taken off.
    std::vector<double> draw(std::size_t count, std::size_t quiet, std::mt19937_64& random) const;

  private:
    double density(double frequency) const;

    std::vector<double> m_coefficients;
    double m_innovation = 0;
    double m_deviation = 0;
    double m_longRun = 0;
    double m_step = 1;
    double m_lowest = 0;  ///< frequency below which 1/f joins [Hz]
};

/// A standard normal number; the same on every machine for the same generator.
double standardNormal(std::mt19937_64& random);

}  // namespace drillwave
