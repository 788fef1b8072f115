// SPDX-License-Identifier: GPL-3.0-or-later
// First zero of a polynomial. The exact solver uses it to find the time of the event that ends a contact
// phase or a free flight.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/numeric/power_series.h"

namespace drillwave {

/// Result of the search for the first zero u of a function that is positive at the start of the search.
template <class Real>
struct Zero {
    bool found = false;
    bool undecided = false;  ///< the search gave up: `found` is false, but there may be a zero
    Real u = 0;

    static Zero at(Real u) { return {.found = true, .undecided = false, .u = u}; }
};

/// Statistics of the work of firstZero(): number of searches that simple bounds could not decide, and effort
/// of these searches.
struct SearchCount {
    long searches = 0;
    long samples = 0;  ///< evaluated points or checked intervals, in all searches together
};

/// Polynomial Σ c_k u^k of a local coordinate u, whose origin can be moved. `count` is the number of
/// coefficients.
template <class Real>
struct LocalPolynomial {
    static constexpr int capacity = PowerSeries<Real>::capacity + 1;
    int count = 0;
    std::array<Real, capacity> c;

    void moveBy(Real u) { drillwave::moveBy(c.data(), count, u); }
    /// Returns the same polynomial with its interval [0, width] scaled to [0, 1].
    LocalPolynomial over(Real width) const {
        LocalPolynomial p;
        p.count = count;
        Real power = 1;
        for (int k = 0; k < count; ++k, power *= width) p.c[k] = c[k] * power;
        return p;
    }
    /// Returns a lower bound of the polynomial over 0 ≤ u ≤ 1.
    Real least() const {
        Real sum = c[0];
        for (int k = 1; k < count; ++k) sum += std::min(c[k], Real(0));
        return sum;
    }
    /// Returns an upper bound of the derivative of the polynomial over 0 ≤ u ≤ 1.
    Real steepest() const {
        Real sum = count > 1 ? c[1] : Real(0);
        for (int k = 2; k < count; ++k) sum += Real(k) * std::max(c[k], Real(0));
        return sum;
    }
    Real value(Real u) const { return polynomialValue(c.data(), count, u); }
};

/// Returns p(u) and p'(u) of the polynomial p(u) = Σ c_k u^k. Even and odd powers have separate Horner
/// schemes in u², so that the processor computes them in parallel.
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

/// Result of marchToZero(): a zero was reached, the end was passed without a zero, or the number of steps ran
/// out.
enum class MarchEnd { zero, passed, exhausted };

/// Returns the largest step h for which value + slope·h − bend·h²/2 ≥ 0, or a little less. This is a safe
/// step towards the first zero of a function with p'' ≥ −bend. If the slope is steep and negative, a lower
/// bound of h replaces the exact formula, to save a square root.
template <class Real>
Real stepOver(Real value, Real slope, Real bend) {
    constexpr Real tiny = std::numeric_limits<Real>::min();
    const Real square = slope * slope, bent = bend * value;
    if (slope < 0 && bent < square) return -value * slope / (square + bent / 2);
    const Real root = std::sqrt(square + 2 * bent);
    return slope > 0 ? (slope + root) / (bend + tiny) : 2 * value / (root - slope + tiny);
}

/// Advances u in steps towards `end`, until p(u) = Σ c_k u^k is zero (at most `noise`, and falling) or u
/// passes `end`. Returns which of the two came first, or that 24 steps were too few. Requires p(u) ≥ 0 at the
/// start and −bend ≤ p'' ≤ rise, with bend and rise ≥ 0; these bounds limit the steps, so that no step passes
/// a zero. Convergence is quadratic. The number of steps is written to `step`. Always inlined, as a call
/// takes 1.5 % of the time of a solution.
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
        // p is at most (bend + rise) h²/2 here, and falling
        if ((bend + rise) * h * h <= noise && slope + rise * h <= 0) return MarchEnd::zero;
    }
    return MarchEnd::exhausted;
}

/// Returns the zero, found by bisection, of a polynomial that falls throughout [0, 1], with p(0) > 0 > p(1).
template <class Real>
Real zeroOfFalling(const LocalPolynomial<Real>& p) {
    Real low = 0, high = 1;
    for (int step = 0; step < std::numeric_limits<Real>::digits + 4; ++step) {
        const Real middle = (low + high) / 2;
        (p.value(middle) > 0 ? low : high) = middle;
    }
    return high;
}

/// Returns the first zero in (from, end] of a polynomial for which marchToZero() needs too many steps.
/// Halves the interval until each part has no zero or one crossing. A minimum at most `noise` below zero
/// does not count as a zero. `samples` is increased by the number of checked parts.
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

/// Returns the first zero in (start, end] of p(u) = Σ c_k u^k, with end ≤ 1 and p > 0 just after `start`. If
/// `start` is 0, a zero at u = 0 is removed by division. If p is then negative just after 0, the zero
/// returned is 0. The effort is added to `tally`.
template <class Real>
Zero<Real> firstZero(const Real* c, int count, Real end, SearchCount& tally, Real start = 0) {
    if (start == 0)
        while (count > 0 && c[0] == 0) ++c, --count;
    if (count == 0) return {};
    if (start == 0 && c[0] < 0) return Zero<Real>::at(0);
    // Bounds over [0, 1] by Horner's scheme: c_k + u r(u) ≥ c_k + min(least r, 0). They are narrow even if
    // coefficients of alternating signs cancel.
    Real size = 0, least = 0;
    for (int k = count - 1; k >= 0; --k) {
        size += std::abs(c[k]);
        least = c[k] + std::min(least, Real(0));
    }
    const Real noise = 4 * std::numeric_limits<Real>::epsilon() * size;
    if (start == 0 && least > noise) return {};
    Real leastBend = 0, mostBend = 0;  // bounds of p''
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

/// Calls found(x) for each x in (0, length) at which f changes from positive to negative, which is a maximum
/// of the integral of f. Returns false if the search for a zero was undecided, so that maxima may be
/// missing.
template <class Real, class Found>
bool forEachMaximum(const PowerSeries<Real>& f, Real length, Found found) {
    if (f.isZero()) return true;
    Real signedCoefficients[PowerSeries<Real>::capacity];
    Real start = 0;
    SearchCount uncounted;  // not counted: this search finds no event
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
