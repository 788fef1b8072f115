// SPDX-License-Identifier: GPL-3.0-or-later
// A truncated power series on a short interval: the robust representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {

/// Σ c_k u^k.
template <class Real>
Real polynomialValue(const Real* c, int count, Real u) {
    Real sum = 0;
    for (int k = count - 1; k >= 0; --k) sum = sum * u + c[k];
    return sum;
}

/// f(x) = Σ c_k u^k, u = x/scale, on 0 ≤ x ≤ length ≤ scale. No coefficients: exactly zero.
template <class Real>
struct PowerSeries {
    static constexpr int capacity = 30;

    Real length = 0;
    Real scale = 1;
    int count = 0;
    std::array<Real, capacity> c;

    PowerSeries() {}
    PowerSeries(const PowerSeries& other) { *this = other; }
    /// Copies the coefficients in use only: most pieces are short.
    PowerSeries& operator=(const PowerSeries& other) {
        length = other.length;
        scale = other.scale;
        count = other.count;
        std::copy_n(other.c.begin(), count, c.begin());
        return *this;
    }

    /// 1/k, 0 < k ≤ capacity + 1: divisions would be half of an integral.
    static Real inverse(int k) {
        static constexpr auto table = [] {
            std::array<Real, capacity + 2> t{};
            for (int i = 1; i < capacity + 2; ++i) t[i] = 1 / Real(i);
            return t;
        }();
        return table[k];
    }

    static PowerSeries zero(Real length) {
        PowerSeries f;
        f.length = length;
        f.scale = length;
        return f;
    }

    bool isZero() const { return count == 0; }
    Real startValue() const { return count > 0 ? c[0] : Real(0); }

    Real value(Real x) const { return polynomialValue(c.data(), count, x / scale); }

    /// ∫ from 0 to x.
    Real integral(Real x) const {
        const Real u = x / scale;
        Real sum = 0;
        for (int k = count - 1; k >= 0; --k) sum = sum * u + c[k] * inverse(k + 1);
        return sum * x;
    }

    /// An upper bound of ∫f over [0, x] for every x up to the length, and 0.
    Real mostIntegral() const {
        Real most = 0;
        for (int k = 0; k < count; ++k) most += std::max(c[k], Real(0)) * inverse(k + 1);
        return most * length;
    }

    /// Σ|c_k| ≥ max|f|, the size that rounding errors are relative to.
    Real magnitude() const {
        Real sum = 0;
        for (int k = 0; k < count; ++k) sum += std::abs(c[k]);
        return sum;
    }

    /// ≥ ∫|f|, the size that the rounding of the integral is relative to.
    Real integralOfSizes() const { return magnitude() * length; }

    /// An upper bound of f.
    Real mostValue() const {
        Real most = startValue();
        for (int k = 1; k < count; ++k) most += std::max(c[k], Real(0));
        return most;
    }

    /// Drops trailing coefficients of at most `negligible`.
    void trim(Real negligible) {
        while (count > 0 && std::abs(c[count - 1]) <= negligible) --count;
    }

    /// The same function with u = x/newScale.
    void rescale(Real newScale) {
        const Real ratio = newScale / scale;
        Real power = 1;
        for (int k = 1; k < count; ++k) c[k] *= (power *= ratio);
        scale = newScale;
    }

    /// The same function seen from x: Taylor shift, then the interval [x, length].
    void dropFront(Real x) {
        const Real u = x / scale;
        for (int i = 0; i + 1 < count; ++i)
            for (int k = count - 2; k >= i; --k) c[k] += u * c[k + 1];
        length -= x;
    }

    /// Ends the interval at x.
    void shorten(Real x) { length = x; }

    /// ∫ f·g over [0, x]; both must have the same scale.
    static Real productIntegral(const PowerSeries& f, const PowerSeries& g, Real x) {
        assert(f.scale == g.scale);
        const Real u = x / f.scale;
        Real sum = 0;
        for (int n = f.count + g.count - 2; n >= 0; --n) {
            Real convolution = 0;
            const int first = std::max(0, n - g.count + 1);
            const int last = std::min(n, f.count - 1);
            for (int k = first; k <= last; ++k) convolution += f.c[k] * g.c[n - k];
            sum = sum * u + convolution / Real(n + 1);
        }
        return sum * x;
    }
};

}  // namespace drillwave
