// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numeric/brent.h"

namespace drillwave {

namespace {

/// cos(π j/(2·16)), from which the cosines of all node counts are taken.
double cosine(std::size_t j, std::size_t of) {
    return std::cos(std::numbers::pi * static_cast<double>(j) / static_cast<double>(of));
}

/// Σ c_k T_k(u) by Clenshaw's recurrence.
double sum(std::span<const double> c, double u) {
    double b1 = 0, b2 = 0;
    for (std::size_t k = c.size(); k-- > 1;) {
        const double b0 = 2 * u * b1 - b2 + c[k];
        b2 = b1;
        b1 = b0;
    }
    return c.empty() ? 0 : u * b1 - b2 + c[0];
}

/// cos(π i/n) for i = 0 … 2n − 1.
const std::vector<double>& cosinesOf(std::size_t n) {
    static const auto tables = [] {
        std::array<std::vector<double>, Chebyshev::mostNodes> all;
        for (std::size_t of = 1; of < all.size(); ++of)
            for (std::size_t i = 0; i < 2 * of; ++i) all[of].push_back(cosine(i, of));
        return all;
    }();
    return tables[n];
}

}  // namespace

Chebyshev::Chebyshev(double a, double b, std::span<const double> values)
    : m_start(a), m_end(b), m_count(values.size()) {
    const std::size_t n = m_count - 1;
    const std::vector<double>& cosines = cosinesOf(n);
    for (std::size_t k = 0; k <= n; ++k) {
        double c = (values[0] + (k % 2 == 0 ? values[n] : -values[n])) / 2;
        for (std::size_t j = 1; j < n; ++j) c += values[j] * cosines[j * k % (2 * n)];
        // the nodes ascend, the cosines descend
        m_coefficients[k] = (k % 2 == 0 ? c : -c) * (k == 0 || k == n ? 1.0 : 2.0) / static_cast<double>(n);
    }
    const double scale = 2 / (b - a);
    double next = 0, afterNext = 0;  // d_{k+1}, d_{k+2}
    for (std::size_t k = n; k-- > 0;) {
        const double d = afterNext + 2 * static_cast<double>(k + 1) * m_coefficients[k + 1] * scale;
        m_slopes[k] = k == 0 ? d / 2 : d;
        afterNext = next;
        next = d;
    }
}

double Chebyshev::node(double a, double b, std::size_t j, std::size_t count) {
    if (j == 0) return a;
    if (j + 1 == count) return b;
    const double u = -cosinesOf(count - 1)[j];
    return a + (b - a) * ((1 + u) / 2);
}

double Chebyshev::operator()(double x) const {
    return sum(std::span(m_coefficients).first(m_count), position(x));
}

double Chebyshev::slope(double x) const {
    return sum(std::span(m_slopes).first(m_count - 1), position(x));
}

double Chebyshev::tail() const {
    double largest = 0;
    for (std::size_t k = m_count - std::min<std::size_t>(3, m_count - 1); k < m_count; ++k)
        largest = std::max(largest, std::abs(m_coefficients[k]));
    return largest;
}

std::vector<double> Chebyshev::stationaryPoints() const {
    std::vector<double> points;
    const std::size_t probes = 2 * mostNodes - 1;  // twice as many as p' can have zeros
    double a = m_start, slopeA = slope(a);
    for (std::size_t j = 1; j < probes; ++j) {
        const double b = m_start + (m_end - m_start) * (1 - cosine(j, probes - 1)) / 2;
        const double slopeB = slope(b);
        if (slopeB == 0) continue;
        if (slopeA != 0 && (slopeA > 0) != (slopeB > 0))
            points.push_back(brentRoot([this](double x) { return slope(x); }, a, slopeA, b, slopeB));
        a = b;
        slopeA = slopeB;
    }
    return points;
}

}  // namespace drillwave
