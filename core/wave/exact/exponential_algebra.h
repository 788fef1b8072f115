// SPDX-License-Identifier: GPL-3.0-or-later
// Linear combinations of exponential sums, term by term.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Computes the coefficients out = p·g + q·f for numbers p and q, for terms of one kind and one rate.
inline void combine(double p, const Coefficients& g, double q, const Coefficients& f, Coefficients& out) {
    const int common = std::min(g.count, f.count);
    for (int m = 0; m < common; ++m) out.c[m] = p * g.c[m] + q * f.c[m];
    for (int m = common; m < g.count; ++m) out.c[m] = p * g.c[m];
    for (int m = common; m < f.count; ++m) out.c[m] = q * f.c[m];
    out.count = std::max(g.count, f.count);
}

/// Computes the coefficients `factor`·(c_{m+1} − c_m) from the c_m in `terms`. If `factor` is λ, they are
/// those of the derivative of Σ c_m φ_m(λx), with φ_m(y) = e^(−y) y^m/m!.
inline void differences(const Coefficients& terms, double factor, Coefficients& slope) {
    slope.count = terms.count;
    const int last = terms.count - 1;
    for (int m = 0; m < last; ++m) slope.c[m] = factor * (terms.c[m + 1] - terms.c[m]);
    if (last >= 0) slope.c[last] = -factor * terms.c[last];
}

/// Computes the terms of out = p·g + q·f that sloped and curved hammer forces leave, and sets isCurved of
/// `out`.
template <int lines>
void combineCurves(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                   ExponentialSum<lines>& out);

/// Computes out = p·g + q·f for exponential sums g and f and numbers p and q. `out` must be a different
/// object. It gets length and rates from g.
template <int lines>
inline void combine(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                    ExponentialSum<lines>& out) {
    if (g.isCurved || f.isCurved) [[unlikely]]
        combineCurves(p, g, q, f, out);
    else
        out.isCurved = false;
    out.length = g.length;
    out.c0 = p * g.c0 + q * f.c0;
    eachLine<lines>([&](int i) { combine(p, g.decays[i], q, f.decays[i], out.decays[i]); });
    out.wholeDecays = g.wholeDecays;
    out.rates = g.rates;
}

/// Computes the exponential sum out = −f; both may be the same object.
template <int lines>
inline void negate(const ExponentialSum<lines>& f, ExponentialSum<lines>& out) {
    const auto turn = [](const Coefficients& terms, Coefficients& turned) {
        turned.count = terms.count;
        for (int m = 0; m < terms.count; ++m) turned.c[m] = -terms.c[m];
    };
    if (f.isCurved) [[unlikely]] {
        CurvedTerms<lines>& curve = out.makeCurved();
        curve.c1 = -f.curve.c1;
        eachLine<lines>([&](int i) { turn(f.curve.rises[i], curve.rises[i]); });
        curve.hammer = f.curve.hammer.negated();
    } else {
        out.isCurved = false;
    }
    out.length = f.length;
    out.c0 = -f.c0;
    eachLine<lines>([&](int i) { turn(f.decays[i], out.decays[i]); });
    out.wholeDecays = f.wholeDecays;
    out.rates = f.rates;
}

// Values of a response at the end of a stretch of contact, and bounds of their errors

/// Maximum of φ_m(y) = e^(−y) y^m/m! over y, at y = m, for each order m.
inline constexpr double largestDecays[Coefficients::capacity] = {1,
                                                                 0.36787944117144233,
                                                                 0.27067056647322538,
                                                                 0.22404180765538775,
                                                                 0.19536681481316454,
                                                                 0.17546736976785068,
                                                                 0.16062314104798003,
                                                                 0.14900277967433771};

/// Value of Σ c_m φ_m(λx) at x, with φ_m(y) = e^(−y) y^m/m!, and its integral over [0, x], computed in one
/// pass. The members `higherSize`, `stored` and `integrated`, times the machine epsilon, estimate rounding
/// errors. After many reflections, coefficients of high order are large, but have little effect where λx is
/// small. So `stored` uses the largest value of each term up to x.
struct DecaysEnd {
    /// Coefficient c_0, decay φ_0(λx) = e^(−λx), and 1 − e^(−λx), the part by which this decay has fallen.
    double first, firstDecay, firstRise;
    /// Sum c_1 φ_1 + c_2 φ_2 + … at x, with the decays φ_m = e^(−λx) (λx)^m/m!, in units of F0.
    double higher = 0;
    /// Sum of the absolute values of the terms c_1 φ_1, c_2 φ_2, … at x, in units of F0.
    double higherSize = 0;
    /// Integral of Σ c_m φ_m(λx) over [0, x], in units of I0.
    double integral = 0;
    /// Magnitude that, times the machine epsilon, estimates the error of `integral` due to rounded
    /// coefficients, in units of I0.
    double stored = 0;
    /// Magnitude that, times the machine epsilon, estimates the rounding error of `integral`, in units of I0.
    double integrated = 0;

    /// Computes Σ c_m φ_m(λx) at x, its integral and their errors. `terms` holds the c_m, `rate` is λ, and
    /// `decay` is e^(−λx).
    DecaysEnd(const Coefficients& terms, double rate, double x, double decay);

    /// Returns Σ c_m φ_m(λx) at the position x of the constructor, in units of F0.
    double value() const { return first * firstDecay + higher; }
    /// Returns the sum of the absolute terms of value(), in units of F0. Times the machine epsilon, it
    /// estimates the rounding error of value().
    double valueSize() const { return std::abs(first) * firstDecay + higherSize; }
    /// Returns the change of Σ c_m φ_m(λx) from 0 to the position x of the constructor, in units of F0.
    double change() const { return higher - first * firstRise; }
    /// Returns the sum of the absolute terms of change(), in units of F0. Times the machine epsilon, it
    /// estimates the rounding error of change().
    double changeSize() const { return std::abs(first) * firstRise + higherSize; }
};

inline DecaysEnd::DecaysEnd(const Coefficients& terms, double rate, double x, double decay)
    : first(terms.c[0]), firstDecay(decay) {
    constexpr double few = 0.5;  // below it 1 − e^{−y} loses digits
    const double y = rate * x;
    firstRise = y < few ? -std::expm1(-y) : 1 - decay;
    double rise = firstRise, phi = decay, risen = first * rise;
    double sizes = std::abs(first), largest = sizes;
    for (int m = 1; m < terms.count; ++m) {
        phi *= y / m;
        rise -= phi;
        const double term = terms.c[m], size = std::abs(term);
        higher += term * phi;
        higherSize += size * phi;
        risen += term * rise;
        sizes += size;
        largest += size * (y < m ? phi : largestDecays[m]);
    }
    constexpr double lasting = Coefficients::capacity;  // number of 1/λ over which a term may be large
    integral = risen / rate;
    stored = largest * std::min(x, lasting / rate);
    integrated = sizes * std::min(x, 1 / rate);
}

}  // namespace drillwave
