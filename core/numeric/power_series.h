// SPDX-License-Identifier: GPL-3.0-or-later
// A truncated power series on a short interval: the robust representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {

/// Σ c_k u^k with c_k = coefficient(k), by two Horner schemes in u², of the even and of the odd powers: they
/// do not wait for each other.
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

/// Σ c_k u^k.
template <class Real>
Real polynomialValue(const Real* c, int count, Real u) {
    return polynomialOf(count, u, [c](int k) { return c[k]; });
}

/// Σ term(k) over first ≤ k < count, in two sums that do not wait for each other.
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

/// The next `passes` of the synthetic divisions of moveBy(), from the coefficient `first` on, in one go: each
/// waits for the one before it only, not for its whole run.
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
    for (; k >= first; --k) {  // the last divisions have ended
        s[0] = c[k] + u * s[0];
        for (int m = 1; m <= k - first; ++m) s[m] = s[m - 1] + u * s[m];
        c[k] = s[k - first];
    }
}

/// Shifts the polynomial to start from u (Taylor shift).
template <class Real>
void moveBy(Real* c, int count, Real u) {
    constexpr int atOnce = 4;
    int first = 0;
    for (; first + atOnce < count; first += atOnce) divide<atOnce>(c, count, first, u);
    for (; first + 1 < count; ++first) divide<1>(c, count, first, u);
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
    /// Copies the coefficients in use only, most pieces are short, in blocks: copies of unknown length are
    /// calls.
    PowerSeries& operator=(const PowerSeries& other) {
        length = other.length;
        scale = other.scale;
        count = other.count;
        constexpr int block = 6;
        static_assert(capacity % block == 0);
        for (int k = 0; k < count; k += block) std::copy_n(other.c.begin() + k, block, c.begin() + k);
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
        return polynomialOf(count, x / scale, [this](int k) { return c[k] * inverse(k + 1); }) * x;
    }

    /// An upper bound of ∫f over [0, x] for every x up to the length, and 0.
    Real mostIntegral() const {
        return sumOf<Real>(0, count, [this](int k) { return std::max(c[k], Real(0)) * inverse(k + 1); }) *
               length;
    }

    /// Σ|c_k| ≥ max|f|, the size that rounding errors are relative to.
    Real magnitude() const {
        return sumOf<Real>(0, count, [this](int k) { return std::abs(c[k]); });
    }

    /// ≥ ∫|f|, the size that the rounding of the integral is relative to.
    Real integralOfSizes() const { return magnitude() * length; }

    /// An upper bound of f.
    Real mostValue() const {
        return startValue() + sumOf<Real>(1, count, [this](int k) { return std::max(c[k], Real(0)); });
    }

    /// Drops trailing coefficients of at most `negligible`.
    void trim(Real negligible) {
        while (count > 0 && std::abs(c[count - 1]) <= negligible) --count;
    }

    /// Changes the scale of the same function to u = x/newScale.
    void rescale(Real newScale) {
        const Real ratio = newScale / scale;
        Real power = 1;
        for (int k = 1; k < count; ++k) c[k] *= (power *= ratio);
        scale = newScale;
    }

    /// Drops the part before x: the same function on the interval [x, length].
    void dropFront(Real x) {
        moveBy(c.data(), count, x / scale);
        length -= x;
    }

    /// Returns ∫ f·g over [0, x]; both must have the same scale.
    static Real productIntegral(const PowerSeries& f, const PowerSeries& g, Real x) {
        assert(f.scale == g.scale);
        if (f.isZero() || g.isZero()) return 0;
        // all coefficients of the product at once: sums that do not wait for each other
        std::array<Real, 2 * capacity - 1> product;
        const int count = f.count + g.count - 1;
        std::fill_n(product.begin(), count, Real(0));
        int k = 0;
        for (; k + 1 < f.count; k += 2) {  // two at a time: half of the time goes by reading and writing sums
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

// Moments of a power series that are kept when another takes its place.

/// Number of moments kept: ∫ f xʲ for j = 0 … 3.
inline constexpr int keptMoments = 4;

/// Adds to `f`, given on the scale of its length, the polynomial of third degree that has the moments of
/// `deviation`: a function on the part [from, from + share] of that interval, both in lengths of f. It is the
/// expansion of the deviation in Legendre polynomials of the whole interval, cut off behind the kept moments.
template <class Real>
void addMoments(PowerSeries<Real>& f, const PowerSeries<Real>& deviation, Real from, Real share) {
    std::array<Real, keptMoments> own;  // ∫ d vʲ dv over the part itself, 0 ≤ v ≤ 1
    for (int j = 0; j < keptMoments; ++j) {
        Real sum = 0;
        for (int k = deviation.count - 1; k >= 0; --k) sum += deviation.c[k] / Real(k + j + 1);
        own[j] = sum;
    }
    // ∫ d uʲ du over the whole interval, u = from + share v
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
