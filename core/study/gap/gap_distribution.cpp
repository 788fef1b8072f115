// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace drillwave {

namespace {

/// Beyond so many standard deviations there is less than 1e-18.
constexpr double reach = 9;

/// Probability of a standard normal variable between a and b, a ≤ b, without loss of digits in the tails.
double between(double a, double b) {
    const auto upper = [](double x) { return std::erfc(x / std::numbers::sqrt2) / 2; };
    return a > 0 ? upper(a) - upper(b) : upper(-b) - upper(-a);
}

}  // namespace

double lowestGap(const NormalGap& normal) {
    return std::max(0.0, normal.mean - reach * normal.deviation);
}

GapDistribution GapDistribution::uniform(const GapCurve& curve) {
    GapDistribution distribution(curve, {});
    distribution.m_cuts = {curve.periodStart, curve.end};
    return distribution;
}

GapDistribution GapDistribution::normal(const GapCurve& curve, const NormalGap& normal) {
    assert(normal.mean >= 0 && normal.deviation >= NormalGap::leastDeviation &&
           normal.deviation <= NormalGap::mostDeviation);
    assert(curve.start <= lowestGap(normal));
    GapDistribution distribution(curve, normal);
    distribution.m_uniform = false;
    distribution.m_total = between(-normal.mean / normal.deviation, INFINITY);
    std::vector<double>& cuts = distribution.m_cuts;
    cuts = {curve.start, curve.periodStart, curve.end};
    const double step = normal.deviation / 2;
    const double least = lowestGap(normal);
    const double most =
        std::min(normal.mean + reach * normal.deviation, std::max(least, curve.periodStart) + 1 + step);
    for (double gap = least; gap < most; gap += step) cuts.push_back(distribution.fold(gap));
    std::ranges::sort(cuts);
    return distribution;
}

GapDistribution::GapDistribution(const GapCurve& curve, const NormalGap& normal)
    : m_periodStart(curve.periodStart), m_normal(normal) {}

double GapDistribution::fold(double gap) const {
    return gap < m_periodStart ? gap : m_periodStart + std::fmod(gap - m_periodStart, 1);
}

double GapDistribution::density(double gap) const {
    if (m_uniform) return gap >= m_periodStart && gap <= m_periodStart + 1 ? 1 : 0;
    const auto at = [this](double x) {
        const double z = (x - m_normal.mean) / m_normal.deviation;
        return std::exp(-z * z / 2);
    };
    double sum = 0;
    if (gap < m_periodStart) {
        sum = at(gap);
    } else {
        const double spread = reach * m_normal.deviation;
        const double first = std::max(0.0, std::ceil(m_normal.mean - spread - gap));
        const double last = std::floor(m_normal.mean + spread - gap);
        for (double k = first; k <= last; ++k) sum += at(gap + k);
    }
    return sum / (m_normal.deviation * std::sqrt(2 * std::numbers::pi) * m_total);
}

double GapDistribution::cumulative(double gap) const {
    if (m_uniform) return std::clamp(gap - m_periodStart, 0.0, 1.0);
    const auto mass = [this](double from, double to) {
        return between((from - m_normal.mean) / m_normal.deviation,
                       (to - m_normal.mean) / m_normal.deviation);
    };
    double sum = mass(0, std::min(gap, m_periodStart));
    if (gap > m_periodStart) {
        const double spread = reach * m_normal.deviation;
        const double first = std::max(0.0, std::ceil(m_normal.mean - spread - gap));
        const double last = std::max(0.0, std::floor(m_normal.mean + spread - m_periodStart));
        for (double k = first; k <= last; ++k) sum += mass(m_periodStart + k, gap + k);
    }
    return sum / m_total;
}

}  // namespace drillwave
