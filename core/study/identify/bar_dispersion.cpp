// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/bar_dispersion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace drillwave {

namespace {

constexpr double modeRatios[] = {0,   0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35,
                                 0.4, 0.45, 0.5, 0.6,  0.8, 1.0,  1.5};
constexpr double modeSpeeds[] = {1,        0.997891, 0.991129, 0.978261, 0.956446,
                                 0.921753, 0.872992, 0.817401, 0.765579, 0.722765,
                                 0.689272, 0.644043, 0.601867, 0.586069, 0.575683};

}  // namespace

double firstModeSpeed(double ratio) {
    const auto* above = std::upper_bound(std::begin(modeRatios), std::end(modeRatios), ratio);
    if (above == std::begin(modeRatios)) return modeSpeeds[0];
    if (above == std::end(modeRatios)) return modeSpeeds[std::size(modeSpeeds) - 1];
    const auto i = static_cast<std::size_t>(above - std::begin(modeRatios));
    // 1 − c/c0 begins with the square of the ratio
    const auto square = [](double x) { return x * x; };
    const double share = i < 6 ? (square(ratio) - square(modeRatios[i - 1])) /
                                     (square(modeRatios[i]) - square(modeRatios[i - 1]))
                               : (ratio - modeRatios[i - 1]) / (modeRatios[i] - modeRatios[i - 1]);
    return modeSpeeds[i - 1] + share * (modeSpeeds[i] - modeSpeeds[i - 1]);
}

BarDispersion::BarDispersion(double outerRadius, double innerRadius, double barSpeed) : m_barSpeed(barSpeed) {
    const double radius = std::hypot(outerRadius, innerRadius);
    for (int i = 0; i <= 150; ++i) {
        const double ratio = i / 100.0, speed = firstModeSpeed(ratio) * barSpeed;
        m_frequencies.push_back(ratio * speed / radius);
        m_slownesses.push_back(1 / speed - 1 / barSpeed);
    }
}

double BarDispersion::slowness(double frequency) const {
    const auto above = std::upper_bound(m_frequencies.begin(), m_frequencies.end(), frequency);
    if (above == m_frequencies.begin()) return 0;
    if (above == m_frequencies.end()) return m_slownesses.back();
    const auto i = static_cast<std::size_t>(above - m_frequencies.begin());
    const double share = (frequency - m_frequencies[i - 1]) / (m_frequencies[i] - m_frequencies[i - 1]);
    return m_slownesses[i - 1] + share * (m_slownesses[i] - m_slownesses[i - 1]);
}

std::vector<double> BarDispersion::delayed(const std::vector<double>& wave, double step, double way) const {
    if (wave.empty()) return {};
    std::size_t length = 64;
    while (length < 2 * wave.size()) length *= 2;
    std::vector<std::complex<double>> time(length, 0.0), spectrum;
    std::copy(wave.begin(), wave.end(), time.begin());
    // A record that ends inside a wave goes on and fades: a step there would reach back into the window.
    const std::size_t free = length - wave.size();
    for (std::size_t i = 0; i < free / 2; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(free / 2);
        time[wave.size() + i] = wave.back() * (0.5 + 0.5 * std::cos(std::numbers::pi * share));
    }
    Eigen::FFT<double> transform;
    transform.fwd(spectrum, time);
    const double interval = 1 / (static_cast<double>(length) * step);
    for (std::size_t k = 1; k < length; ++k) {
        const bool isUpper = k > length / 2;
        const double frequency = static_cast<double>(isUpper ? length - k : k) * interval;
        const double phase = -2 * std::numbers::pi * frequency * way * slowness(frequency);
        spectrum[k] *= std::polar(1.0, isUpper ? -phase : phase);
        if (2 * k == length) spectrum[k] = spectrum[k].real();
    }
    transform.inv(time, spectrum);
    std::vector<double> result(wave.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = time[i].real();
    return result;
}

}  // namespace drillwave
