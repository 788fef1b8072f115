// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/gauge_noise.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "core/numeric/normal_quantile.h"

namespace drillwave {

double standardNormal(std::mt19937_64& random) {
    // in (0, 1), never at its ends
    const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
    return normalQuantile(u);
}

GaugeNoise::GaugeNoise(std::span<const double> quiet, double step, double least) : m_step(step) {
    const std::size_t n = quiet.size();
    const double mean = std::accumulate(quiet.begin(), quiet.end(), 0.0) / static_cast<double>(n);
    const std::size_t order = std::min<std::size_t>(8, n / 20);
    std::vector<double> correlation(order + 1, 0);
    for (std::size_t lag = 0; lag <= order; ++lag) {
        for (std::size_t i = lag; i < n; ++i) correlation[lag] += (quiet[i] - mean) * (quiet[i - lag] - mean);
        correlation[lag] /= static_cast<double>(n);
    }
    m_deviation = std::max(std::sqrt(correlation[0]), least);
    m_lowest = 2 / (static_cast<double>(n) * step);
    double variance = correlation[0];
    if (correlation[0] > 1e-4 * least * least) {
        // Levinson–Durbin: the roots stay inside the unit circle
        for (std::size_t k = 1; k <= order && variance > 1e-6 * correlation[0]; ++k) {
            double sum = correlation[k];
            for (std::size_t j = 1; j < k; ++j) sum -= m_coefficients[j - 1] * correlation[k - j];
            const double reflection = sum / variance;
            std::vector<double> next = m_coefficients;
            next.push_back(reflection);
            for (std::size_t j = 1; j < k; ++j)
                next[j - 1] = m_coefficients[j - 1] - reflection * m_coefficients[k - j - 1];
            m_coefficients = next;
            variance *= 1 - reflection * reflection;
        }
    }
    const double scale = correlation[0] > 0 ? m_deviation / std::sqrt(correlation[0]) : 0;
    m_innovation =
        correlation[0] > 1e-4 * least * least ? std::sqrt(std::max(variance, 0.0)) * scale : m_deviation;
    const double gain = 1 - std::accumulate(m_coefficients.begin(), m_coefficients.end(), 0.0);
    // A model that blocks the mean weighs as white noise; one near a unit root as far as the stretch shows.
    m_longRun = std::clamp(m_innovation / std::max(gain, 1e-3), 0.3 * m_deviation,
                           m_deviation * std::sqrt(static_cast<double>(n)));
}

double GaugeNoise::density(double frequency) const {
    std::complex<double> sum = 1;
    for (std::size_t j = 0; j < m_coefficients.size(); ++j)
        sum -= m_coefficients[j] *
               std::polar(1.0, -2 * std::numbers::pi * frequency * m_step * static_cast<double>(j + 1));
    return 2 * m_step * m_innovation * m_innovation / std::max(std::norm(sum), 1e-9);
}

double GaugeNoise::deviationOfMean(std::size_t span) const {
    // by the response of the autoregressive filter to one innovation
    const std::size_t length = span + 400;
    std::vector<double> response(length, 0);
    for (std::size_t i = 0; i < length; ++i) {
        double value = i == 0 ? 1 : 0;
        for (std::size_t j = 0; j < m_coefficients.size() && j < i; ++j)
            value += m_coefficients[j] * response[i - j - 1];
        response[i] = value;
    }
    double sum = 0, power = 0;
    for (std::size_t i = 0; i < length + span; ++i) {
        sum += (i < length ? response[i] : 0) - (i >= span && i - span < length ? response[i - span] : 0);
        power += sum * sum;
    }
    return m_innovation * std::sqrt(power) / static_cast<double>(span);
}

std::vector<double> GaugeNoise::draw(std::size_t count, std::size_t quiet, std::mt19937_64& random) const {
    constexpr std::size_t warmUp = 200;
    std::vector<double> noise(count + warmUp, 0);
    for (std::size_t i = 0; i < noise.size(); ++i) {
        double value = m_innovation * standardNormal(random);
        for (std::size_t j = 0; j < m_coefficients.size() && j < i; ++j)
            value += m_coefficients[j] * noise[i - j - 1];
        noise[i] = value;
    }
    noise.erase(noise.begin(), noise.begin() + warmUp);
    // 1/f: S(f1) (f1/f − 1) from f1/64 to f1 in bands of a third of an octave
    constexpr int bands = 18;
    const double atLowest = density(m_lowest);
    for (int i = 0; i < bands; ++i) {
        const double high = m_lowest * std::exp2(-i / 3.0), low = high * std::exp2(-1 / 3.0);
        const double middle = std::sqrt(low * high);
        const double amplitude = std::sqrt(atLowest * (m_lowest / middle - 1) * (high - low));
        const double c = amplitude * standardNormal(random), s = amplitude * standardNormal(random);
        const double turn = 2 * std::numbers::pi * middle * m_step;
        for (std::size_t k = 0; k < count; ++k) {
            const double phase = turn * static_cast<double>(k);
            noise[k] += c * std::cos(phase) + s * std::sin(phase);
        }
    }
    double mean = 0;
    for (std::size_t k = 0; k < quiet; ++k) mean += noise[k];
    mean /= static_cast<double>(std::max<std::size_t>(quiet, 1));
    for (double& value : noise) value -= mean;
    return noise;
}

}  // namespace drillwave
