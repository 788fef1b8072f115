// SPDX-License-Identifier: GPL-3.0-or-later
// Noise of a gauge, modelled from the samples before the front; generates further noise of the same kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace drillwave {

/// Noise model of a strain gauge: n_i = Σ a_j n_(i−j) + e_i with normally distributed e_i (autoregressive).
/// It is fitted to the samples before the blow. Below the lowest frequency that these samples resolve, noise
/// with a spectral density ∝ 1/f is added.
class GaugeNoise {
  public:
    GaugeNoise() = default;
    /// Fits the noise model to `quiet`, the samples before the front of the blow, minus their mean. `step` is
    /// the time between samples [s]. The standard deviation is at least `least` > 0, in the unit of the
    /// samples.
    GaugeNoise(std::span<const double> quiet, double step, double least);

    /// Returns the standard deviation of the noise in one sample, in the unit of the samples.
    double deviation() const { return m_deviation; }
    /// Returns the long-run standard deviation σ_e/(1 − Σa_j), limited to plausible values. The mean of a
    /// large number n of samples has the standard deviation longRun()/√n.
    double longRun() const { return m_longRun; }
    /// Returns the standard deviation of the mean of `span` successive samples, according to this model.
    double deviationOfMean(std::size_t span) const;

    /// Returns `count` random samples of the noise. As for the zero level of a record, the mean of the first
    /// `quiet` samples is subtracted from all.
    std::vector<double> draw(std::size_t count, std::size_t quiet, std::mt19937_64& random) const;

  private:
    double density(double frequency) const;

    std::vector<double> m_coefficients;
    double m_innovation = 0;
    double m_deviation = 0;
    double m_longRun = 0;
    double m_step = 1;
    double m_lowest = 0;  ///< frequency below which noise ∝ 1/f is added [Hz]
};

/// Returns a random number of the standard normal distribution. The same generator state gives the same
/// number on every machine.
double standardNormal(std::mt19937_64& random);

}  // namespace drillwave
