// SPDX-License-Identifier: GPL-3.0-or-later
// Truncated power series on a short interval, by which the exact solver represents every function of time.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {

/// Returns Σ c_k u^k with c_k = coefficient(k), 0 ≤ k < count. Even and odd powers have separate Horner
/// schemes in u², so that the processor computes them in parallel.
template <class Real, class Coefficient>
Real polynomialOf(int count, Real u, Coefficient coefficient) {
    const Real square = u * u;
    Real even = 0, odd = 0;
    int k = count - 1;
    if (k >= 0 && k % 2 == 0) even = coefficient(k--);
    for (; k > 0; k -= 2) {
        odd = odd * square + coefficient(k);
        even = even * square + coefficient(k - 1);
    }
    return even + u * odd;
}

/// Returns the value of the polynomial Σ c_k u^k, 0 ≤ k < count, at u.
template <class Real>
Real polynomialValue(const Real* c, int count, Real u) {
    return polynomialOf(count, u, [c](int k) { return c[k]; });
}

/// Returns Σ term(k) over first ≤ k < count, as two sums that the processor computes in parallel.
template <class Real, class Term>
Real sumOf(int first, int count, Term term) {
    Real sum = 0, other = 0;
    int k = first;
    for (; k + 1 < count; k += 2) {
        sum += term(k);
        other += term(k + 1);
    }
    if (k < count) sum += term(k);
    return sum + other;
}

/// Performs `passes` synthetic divisions of the polynomial Σ c_k x^k by (x − u) at once, from coefficient
/// `first` on. Such divisions give the Taylor shift in moveBy(). Each division needs only the current value
/// of the previous one, so that the processor computes them in parallel.
template <int passes, class Real>
void divide(Real* c, int count, int first, Real u) {
    std::array<Real, passes> s;
    s.fill(c[count - 1]);
    int k = count - 2;
    for (; k >= first + passes - 1; --k) {
        s[0] = c[k] + u * s[0];
        for (int m = 1; m < passes; ++m) s[m] = s[m - 1] + u * s[m];
        c[k] = s[passes - 1];
    }
    for (; k >= first; --k) {  // one division fewer in each step
        s[0] = c[k] + u * s[0];
        for (int m = 1; m <= k - first; ++m) s[m] = s[m - 1] + u * s[m];
        c[k] = s[k - first];
    }
}

/// Replaces the `count` coefficients c of a polynomial p(x) by those of p(x + u), with the shift u (Taylor
/// shift).
template <class Real>
void moveBy(Real* c, int count, Real u) {
    constexpr int atOnce = 4;
    int first = 0;
    for (; first + atOnce < count; first += atOnce) divide<atOnce>(c, count, first, u);
    for (; first + 1 < count; ++first) divide<1>(c, count, first, u);
}

/// Function f(x) = Σ c_k u^k with u = x/scale, on 0 ≤ x ≤ length ≤ scale. Without coefficients f is exactly
/// zero.
template <class Real>
struct PowerSeries {
    static constexpr int capacity = 30;

    Real length = 0;
    Real scale = 1;
    int count = 0;
    std::array<Real, capacity> c;

    PowerSeries() {}
    PowerSeries(const PowerSeries& other) { *this = other; }
    /// Copies only the coefficients in use, as most series are short. They are copied in blocks, because
    /// copies of unknown length become function calls.
    PowerSeries& operator=(const PowerSeries& other) {
        length = other.length;
        scale = other.scale;
        count = other.count;
        constexpr int block = 6;
        static_assert(capacity % block == 0);
        for (int k = 0; k < count; k += block) std::copy_n(other.c.begin() + k, block, c.begin() + k);
        return *this;
    }

    /// Returns 1/k from a table, 0 < k ≤ capacity + 1. Divisions would take half of the computing time of an
    /// integral.
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

    /// Returns the integral of f from 0 to x, 0 ≤ x ≤ length.
    Real integral(Real x) const {
        return polynomialOf(count, x / scale, [this](int k) { return c[k] * inverse(k + 1); }) * x;
    }

    /// Returns an upper bound of the integral of f from 0 to x that holds for every x from 0 to `length`.
    /// The bound is at least 0.
    Real mostIntegral() const {
        return sumOf<Real>(0, count, [this](int k) { return std::max(c[k], Real(0)) * inverse(k + 1); }) *
               length;
    }

    /// Returns Σ|c_k|, which is at least max|f|; times the machine epsilon, it estimates the rounding error
    /// of f.
    Real magnitude() const {
        return sumOf<Real>(0, count, [this](int k) { return std::abs(c[k]); });
    }

    /// Returns an upper bound of ∫|f| over [0, length]; times the machine epsilon, it estimates the rounding
    /// error of the integral of f.
    Real integralOfSizes() const { return magnitude() * length; }

    /// Returns an upper bound of f over 0 ≤ x ≤ length.
    Real mostValue() const {
        return startValue() + sumOf<Real>(1, count, [this](int k) { return std::max(c[k], Real(0)); });
    }

    /// Drops trailing coefficients whose absolute value is at most `negligible`.
    void trim(Real negligible) {
        while (count > 0 && std::abs(c[count - 1]) <= negligible) --count;
    }

    /// Changes the scale to `newScale`, and the coefficients so that the function stays the same; then u =
    /// x/newScale.
    void rescale(Real newScale) {
        const Real ratio = newScale / scale;
        Real power = 1;
        for (int k = 1; k < count; ++k) c[k] *= (power *= ratio);
        scale = newScale;
    }

    /// Removes the part of f before x, so that the function starts at x and its length decreases by x.
    void dropFront(Real x) {
        moveBy(c.data(), count, x / scale);
        length -= x;
    }

    /// Returns the integral of f·g from 0 to x. Requires that both have the same scale.
    static Real productIntegral(const PowerSeries& f, const PowerSeries& g, Real x) {
        assert(f.scale == g.scale);
        if (f.isZero() || g.isZero()) return 0;
        // all coefficients of the product at once, as sums that the processor computes in parallel
        std::array<Real, 2 * capacity - 1> product;
        const int count = f.count + g.count - 1;
        std::fill_n(product.begin(), count, Real(0));
        int k = 0;
        // two at a time: half of the time is spent reading and writing sums
        for (; k + 1 < f.count; k += 2) {
            const Real first = f.c[k], second = f.c[k + 1];
            product[k] += first * g.c[0];
            for (int j = 1; j < g.count; ++j)
                product[k + j] = product[k + j] + first * g.c[j] + second * g.c[j - 1];
            product[k + g.count] += second * g.c[g.count - 1];
        }
        for (; k < f.count; ++k)
            for (int j = 0; j < g.count; ++j) product[k + j] += f.c[k] * g.c[j];
        for (int n = 0; n < count; ++n) product[n] /= Real(n + 1);
        const Real u = x / f.scale;
        Real sum = 0;
        for (int n = count; n-- > 0;) sum = sum * u + product[n];
        return sum * x;
    }
};

// Polynomial that preserves the moments of a power series when another series replaces it.

/// Number of moments ∫ f xʲ dx, j = 0 … 3, that addMoments() preserves when one series replaces another.
inline constexpr int keptMoments = 4;

/// Corrects a series `f` that differs from the exact function by `deviation` (exact minus f). Adds to `f` a
/// cubic polynomial p with the same moments ∫ p uʲ du, j = 0 … 3, as `deviation`, over 0 ≤ u ≤ 1. It is the
/// expansion of `deviation` in Legendre polynomials up to the third degree. `deviation` is zero outside
/// [from, from + share]. Requires f.scale = f.length.
template <class Real>
void addMoments(PowerSeries<Real>& f, const PowerSeries<Real>& deviation, Real from, Real share) {
    std::array<Real, keptMoments> own;  // ∫ d vʲ dv over the interval of the deviation, 0 ≤ v ≤ 1
    for (int j = 0; j < keptMoments; ++j) {
        Real sum = 0;
        for (int k = deviation.count - 1; k >= 0; --k) sum += deviation.c[k] / Real(k + j + 1);
        own[j] = sum;
    }
    // ∫ d uʲ du over the entire interval, u = from + share v
    const std::array<Real, keptMoments> moments{
        share * own[0], share * (from * own[0] + share * own[1]),
        share * (from * from * own[0] + 2 * from * share * own[1] + share * share * own[2]),
        share * (from * from * from * own[0] + 3 * from * share * (from * own[1] + share * own[2]) +
                 share * share * share * own[3])};
    static constexpr int legendre[keptMoments][keptMoments] = {// on [0, 1], Pₙ(1) = 1
                                                               {1, 0, 0, 0},
                                                               {-1, 2, 0, 0},
                                                               {1, -6, 6, 0},
                                                               {-1, 12, -30, 20}};
    for (int k = f.count; k < keptMoments; ++k) f.c[k] = 0;
    f.count = std::max(f.count, keptMoments);
    for (int n = 0; n < keptMoments; ++n) {
        Real share_n = 0;
        for (int j = 0; j <= n; ++j) share_n += Real(legendre[n][j]) * moments[j];
        share_n *= Real(2 * n + 1);
        for (int j = 0; j <= n; ++j) f.c[j] += share_n * Real(legendre[n][j]);
    }
}

}  // namespace drillwave
