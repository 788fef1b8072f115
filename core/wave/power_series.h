// A truncated power series on a short interval: the robust representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drillwave {

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

    static PowerSeries zero(Real length) {
        PowerSeries f;
        f.length = length;
        f.scale = length;
        return f;
    }

    bool isZero() const { return count == 0; }
    Real startValue() const { return count > 0 ? c[0] : Real(0); }

    Real value(Real x) const {
        const Real u = x / scale;
        Real sum = 0;
        for (int k = count - 1; k >= 0; --k) sum = sum * u + c[k];
        return sum;
    }

    /// ∫ from 0 to x.
    Real integral(Real x) const {
        const Real u = x / scale;
        Real sum = 0;
        for (int k = count - 1; k >= 0; --k) sum = sum * u + c[k] / Real(k + 1);
        return sum * x;
    }

    /// Σ|c_k| ≥ max|f|, the size that rounding errors are relative to.
    Real magnitude() const {
        Real sum = 0;
        for (int k = 0; k < count; ++k) sum += std::abs(c[k]);
        return sum;
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

/// Outcome of the search for the first zero of a function that starts positive.
template <class Real>
struct Zero {
    bool found = false;
    Real u = 0;
};

/// A polynomial seen from one point: the coefficients are relative to it.
template <class Real>
struct LocalPolynomial {
    static constexpr int capacity = PowerSeries<Real>::capacity + 1;
    int count = 0;
    std::array<Real, capacity> c;

    void moveBy(Real u) {
        for (int i = 0; i + 1 < count; ++i)
            for (int k = count - 2; k >= i; --k) c[k] += u * c[k + 1];
    }
};

/// Where a march along a polynomial ended.
enum class MarchEnd { zero, passed, exhausted };

/// Marches from u towards `end` with steps that the curvature bound `curvature` on the way allows: no zero is
/// stepped over, and a zero is approached quadratically. p(u) must not be negative.
template <class Real>
MarchEnd marchToZero(const Real* c, int count, Real end, Real curvature, Real noise, Real& u, int mostSteps) {
    const Real tiny = std::numeric_limits<Real>::min();
    for (int step = 0; step < mostSteps; ++step) {
        Real value = 0, slope = 0;
        for (int k = count - 1; k >= 0; --k) {
            slope = slope * u + value;
            value = value * u + c[k];
        }
        if (step > 0 && value <= noise && slope <= 0) return MarchEnd::zero;
        value = std::max(value, Real(0));
        // largest h with value + slope h − curvature h²/2 ≥ 0
        const Real root = std::sqrt(slope * slope + 2 * curvature * value);
        const Real h = slope > 0 ? (slope + root) / (curvature + tiny) : 2 * value / (root - slope + tiny);
        u += std::max(h, 8 * std::numeric_limits<Real>::epsilon());
        if (!(u <= end)) return MarchEnd::passed;
    }
    return MarchEnd::exhausted;
}

/// The same search where one curvature bound is too coarse: the interval is cut, and the bounds with it.
template <class Real>
Zero<Real> firstZeroInParts(const Real* c, int count, Real end, Real from, Real noise) {
    LocalPolynomial<Real> p;
    p.count = count;
    std::copy_n(c, count, p.c.begin());
    p.moveBy(from);
    Real u = from, width = (end - from) / 2;
    constexpr int mostParts = 2000;
    for (int part = 0; part < mostParts && width > std::numeric_limits<Real>::epsilon() * end; ++part) {
        LocalPolynomial<Real> q = p;
        Real power = 1, curvature = 0;
        for (int k = 1; k < count; ++k) {
            q.c[k] *= (power *= width);
            curvature += Real(k * (k - 1)) * std::abs(q.c[k]);
        }
        Real x = 0;
        const MarchEnd ended = marchToZero(q.c.data(), count, Real(1), curvature, noise, x, 24);
        if (ended == MarchEnd::zero) return {true, u + width * x};
        const Real advance = ended == MarchEnd::passed ? width : width * x;
        u += advance;
        if (u >= end) return {};
        p.moveBy(advance);
        width = ended == MarchEnd::passed ? std::min(2 * width, end - u) : std::min(width / 4, end - u);
    }
    return {true, u};
}

/// First zero in (start, end] of p(u) = Σ c_k u^k, end ≤ 1, p > 0 just after `start`. Exact zeros of p at u =
/// 0 (leading zero coefficients) are divided out; if p is negative just after 0, the answer is 0.
template <class Real>
Zero<Real> firstZero(const Real* c, int count, Real end, Real start = 0) {
    if (start == 0)
        while (count > 0 && c[0] == 0) ++c, --count;
    if (count == 0) return {};
    if (start == 0 && c[0] < 0) return {true, 0};
    Real slopeSum = 0, curvature = 0;
    for (int k = 1; k < count; ++k) {
        const Real size = std::abs(c[k]);
        slopeSum += size;
        curvature += Real(k * (k - 1)) * size;
    }
    if (start == 0 && c[0] > slopeSum) return {};  // p cannot reach zero on [0, 1]
    const Real noise = 4 * std::numeric_limits<Real>::epsilon() * (std::abs(c[0]) + slopeSum);
    Real u = start;
    switch (marchToZero(c, count, end, curvature, noise, u, 24)) {
        case MarchEnd::zero:
            return {true, u};
        case MarchEnd::passed:
            return {};
        case MarchEnd::exhausted:
            break;
    }
    return firstZeroInParts(c, count, end, u, noise);
}

}  // namespace drillwave
