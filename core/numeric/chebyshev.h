// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth function on an interval as a sum of Chebyshev polynomials through its values.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace drillwave {

/// p(x) = Σ c_k T_k(u), u = (2x − a − b)/(b − a), on [a, b].
class Chebyshev {
  public:
    static constexpr std::size_t mostNodes = 17;

    Chebyshev() = default;
    /// Through `values` at node(a, b, j, values.size()); 2 to mostNodes of them.
    Chebyshev(double a, double b, std::span<const double> values);

    /// The j-th of `count` nodes in [a, b]: extrema of a Chebyshev polynomial, the first is a, the last b.
    /// Every second one of 17 is one of 9.
    static double node(double a, double b, std::size_t j, std::size_t count);

    double operator()(double x) const;
    double slope(double x) const;
    /// Size of the last coefficients: for a smooth function about the error of p.
    double tail() const;
    /// Where p' changes sign inside the interval, ascending.
    std::vector<double> stationaryPoints() const;

  private:
    double position(double x) const { return ((x - m_start) + (x - m_end)) / (m_end - m_start); }

    double m_start = 0;
    double m_end = 1;
    std::size_t m_count = 0;
    std::array<double, mostNodes> m_coefficients{};
    std::array<double, mostNodes> m_slopes{};  // coefficients of p'
};

}  // namespace drillwave
