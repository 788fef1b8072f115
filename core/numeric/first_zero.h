// SPDX-License-Identifier: GPL-3.0-or-later
// The first zero of a polynomial: where an event ends a piece of contact or of free flight.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/numeric/power_series.h"

namespace drillwave {

/// Outcome of the search for the first zero of a function that starts positive.
template <class Real>
struct Zero {
    bool found = false;
    bool undecided = false;  ///< the search ended without an answer: `found` is false and means nothing
    Real u = 0;

    static Zero at(Real u) { return {.found = true, .undecided = false, .u = u}; }
};

/// Work of searches that bounds could not decide.
struct SearchCount {
    long searches = 0;
    long samples = 0;  ///< points, or parts, that they looked at
};

/// A polynomial seen from one point: the coefficients are relative to it.
template <class Real>
struct LocalPolynomial {
    static constexpr int capacity = PowerSeries<Real>::capacity + 1;
    int count = 0;
    std::array<Real, capacity> c;

    void moveBy(Real u) { drillwave::moveBy(c.data(), count, u); }
    /// Returns the same polynomial over [0, 1] instead of [0, width].
    LocalPolynomial over(Real width) const {
        LocalPolynomial p;
        p.count = count;
        Real power = 1;
        for (int k = 0; k < count; ++k, power *= width) p.c[k] = c[k] * power;
        return p;
    }
    /// Lower bound over [0, 1].
    Real least() const {
        Real sum = c[0];
        for (int k = 1; k < count; ++k) sum += std::min(c[k], Real(0));
        return sum;
    }
    /// Upper bound of the slope over [0, 1].
    Real steepest() const {
        Real sum = count > 1 ? c[1] : Real(0);
        for (int k = 2; k < count; ++k) sum += Real(k) * std::max(c[k], Real(0));
        return sum;
    }
    Real value(Real u) const { return polynomialValue(c.data(), count, u); }
};

/// p(u) and p'(u) by two Horner schemes in u², of the even and of the odd powers: they do not wait for each
/// other.
template <class Real>
std::array<Real, 2> valueAndSlope(const Real* c, int count, Real u) {
    const Real square = u * u;
    Real even = 0, odd = 0, evenSlope = 0, oddSlope = 0;
    int k = count - 1;
    if (k % 2 == 0) even = c[k--];
    for (; k > 0; k -= 2) {
        oddSlope = oddSlope * square + odd;
        odd = odd * square + c[k];
        evenSlope = evenSlope * square + even;
        even = even * square + c[k - 1];
    }
    return {even + u * odd, odd + 2 * u * (evenSlope + u * oddSlope)};
}

/// End of a march along a polynomial.
enum class MarchEnd { zero, passed, exhausted };

/// The largest h with value + slope h − bend h²/2 ≥ 0, or somewhat less where that is cheap: where a zero is
/// near, 1 + √(1 + q) ≤ 2 + q/2 spares the root.
template <class Real>
Real stepOver(Real value, Real slope, Real bend) {
    constexpr Real tiny = std::numeric_limits<Real>::min();
    const Real square = slope * slope, bent = bend * value;
    if (slope < 0 && bent < square) return -value * slope / (square + bent / 2);
    const Real root = std::sqrt(square + 2 * bent);
    return slope > 0 ? (slope + root) / (bend + tiny) : 2 * value / (root - slope + tiny);
}

/// Marches from u towards `end` with steps that −bend ≤ p'' ≤ rise, both ≥ 0, on the way allow: no zero is
/// stepped over, and a zero is approached quadratically. p(u) must not be negative. Counts its steps in
/// `step`. Used in each search: a call costs 1.5 % of a solve.
template <class Real>
[[gnu::always_inline]] inline MarchEnd marchToZero(const Real* c, int count, Real end, Real bend, Real rise,
                                                   Real noise, Real& u, int& step) {
    constexpr int mostSteps = 24;
    for (step = 0; step < mostSteps; ++step) {
        auto [value, slope] = valueAndSlope(c, count, u);
        if (step > 0 && value <= noise && slope <= 0) return MarchEnd::zero;
        value = std::max(value, Real(0));
        const Real h = stepOver(value, slope, bend);
        u += std::max(h, 8 * std::numeric_limits<Real>::epsilon());
        if (!(u <= end)) return MarchEnd::passed;
        // p is left at (bend + rise) h²/2 at most, and falling
        if ((bend + rise) * h * h <= noise && slope + rise * h <= 0) return MarchEnd::zero;
    }
    return MarchEnd::exhausted;
}

/// The zero of p in [0, 1], falling all the way with p(0) > 0 > p(1): by bisection.
template <class Real>
Real zeroOfFalling(const LocalPolynomial<Real>& p) {
    Real low = 0, high = 1;
    for (int step = 0; step < std::numeric_limits<Real>::digits + 4; ++step) {
        const Real middle = (low + high) / 2;
        (p.value(middle) > 0 ? low : high) = middle;
    }
    return high;
}

/// The same search for polynomials that one curvature bound does not decide. Cuts the interval until each
/// part has no zero or one crossing. A dip that stays within `noise` of zero does not count as a zero.
template <class Real>
Zero<Real> firstZeroInParts(const Real* c, int count, Real end, Real from, Real noise, long& samples) {
    LocalPolynomial<Real> p;
    p.count = count;
    std::copy_n(c, count, p.c.begin());
    p.moveBy(from);
    const Real narrowest = std::numeric_limits<Real>::epsilon() * end;
    Real u = from, width = (end - from) / 2;
    constexpr int mostParts = 2000;
    for (int part = 0; part < mostParts; ++part) {
        ++samples;
        const LocalPolynomial<Real> q = p.over(width);
        const bool isFree = q.least() >= -noise;
        if (!isFree && q.value(1) < -noise && (q.steepest() < 0 || width <= narrowest))
            return Zero<Real>::at(u + width * (q.c[0] > 0 ? zeroOfFalling(q) : Real(0)));
        if (!isFree && width > narrowest) {
            width /= 2;
            continue;
        }
        u += width;
        if (u >= end) return {};
        p.moveBy(width);
        width = std::min(2 * width, end - u);
    }
    return {.found = false, .undecided = true, .u = u};
}

/// First zero in (start, end] of p(u) = Σ c_k u^k, end ≤ 1, p > 0 just after `start`. Exact zeros of p at u =
/// 0 (leading zero coefficients) are divided out; if p is negative just after 0, the answer is 0. A search is
/// added to `tally`.
template <class Real>
Zero<Real> firstZero(const Real* c, int count, Real end, SearchCount& tally, Real start = 0) {
    if (start == 0)
        while (count > 0 && c[0] == 0) ++c, --count;
    if (count == 0) return {};
    if (start == 0 && c[0] < 0) return Zero<Real>::at(0);
    // Bounds over [0, 1] by Horner's scheme: c_k + u r(u) ≥ c_k + min(least r, 0). They see how coefficients
    // of alternating signs cancel.
    Real size = 0, least = 0;
    for (int k = count - 1; k >= 0; --k) {
        size += std::abs(c[k]);
        least = c[k] + std::min(least, Real(0));
    }
    const Real noise = 4 * std::numeric_limits<Real>::epsilon() * size;
    if (start == 0 && least > noise) return {};
    Real leastBend = 0, mostBend = 0;  // of p''
    for (int k = count - 1; k > 1; --k) {
        const Real bend = Real(k * (k - 1)) * c[k];
        leastBend = bend + std::min(leastBend, Real(0));
        mostBend = bend + std::max(mostBend, Real(0));
    }
    Real u = start;
    int steps = 0;
    const MarchEnd ended = marchToZero(c, count, end, std::max(-leastBend, Real(0)),
                                       std::max(mostBend, Real(0)), noise, u, steps);
    ++tally.searches;
    tally.samples += steps + (ended != MarchEnd::exhausted);
    switch (ended) {
        case MarchEnd::zero:
            return Zero<Real>::at(u);
        case MarchEnd::passed:
            return {};
        case MarchEnd::exhausted:
            break;
    }
    return firstZeroInParts(c, count, end, u, noise, tally.samples);
}

/// Calls found(x) where f falls through zero in (0, length). False when a zero could not be decided.
template <class Real, class Found>
bool forEachMaximum(const PowerSeries<Real>& f, Real length, Found found) {
    if (f.isZero()) return true;
    Real signedCoefficients[PowerSeries<Real>::capacity];
    Real start = 0;
    SearchCount uncounted;  // it is no event that is searched
    bool positive = f.c[0] >= 0;
    for (int crossing = 0; crossing < PowerSeries<Real>::capacity; ++crossing) {
        for (int k = 0; k < f.count; ++k) signedCoefficients[k] = positive ? f.c[k] : -f.c[k];
        const auto zero = firstZero(signedCoefficients, f.count, length / f.scale, uncounted, start);
        if (!zero.found) return !zero.undecided;
        if (positive) found(zero.u * f.scale);
        positive = !positive;
        start = std::max(zero.u, std::numeric_limits<Real>::min());
    }
    return true;
}

}  // namespace drillwave
