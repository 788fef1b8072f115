// SPDX-License-Identifier: GPL-3.0-or-later
// Differences and multiples of exponential sums, term by term.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// out = p·g + q·f
inline void combine(double p, const Coefficients& g, double q, const Coefficients& f, Coefficients& out) {
    const int common = std::min(g.count, f.count);
    for (int m = 0; m < common; ++m) out.c[m] = p * g.c[m] + q * f.c[m];
    for (int m = common; m < g.count; ++m) out.c[m] = p * g.c[m];
    for (int m = common; m < f.count; ++m) out.c[m] = q * f.c[m];
    out.count = std::max(g.count, f.count);
}

/// The slope of Σ c_m φ_m is Σ (c_{m+1} − c_m) φ_m, times the rate: here times `factor`.
inline void differences(const Coefficients& terms, double factor, Coefficients& slope) {
    slope.count = terms.count;
    const int last = terms.count - 1;
    for (int m = 0; m < last; ++m) slope.c[m] = factor * (terms.c[m + 1] - terms.c[m]);
    if (last >= 0) slope.c[last] = -factor * terms.c[last];
}

/// The curved terms of out = p·g + q·f, where g or f has any.
template <int lines>
void combineCurves(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                   ExponentialSum<lines>& out);

/// out = p·g + q·f; `out` is another sum. It has the length and the decays of g.
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

/// out = −f; both may be the same.
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

// Values of a response in closed form at the end of a stretch of contact, and bounds of their errors.

/// Largest values of φ_m, at y = m.
inline constexpr double largestDecays[Coefficients::capacity] = {1,
                                                                 0.36787944117144233,
                                                                 0.27067056647322538,
                                                                 0.22404180765538775,
                                                                 0.19536681481316454,
                                                                 0.17546736976785068,
                                                                 0.16062314104798003,
                                                                 0.14900277967433771};

/// The decays Σ c_m φ_m(λx) of one rate at x, and over [0, x], in one pass; and the sizes that their
/// roundings are relative to. Many reflections leave large coefficients of high order, which hardly count
/// where λx is small: the size of a term is its largest value up to x.
struct DecaysEnd {
    double first, firstDecay, firstRise;  ///< c_0, φ_0(λx) and 1 − φ_0(λx)
    double higher = 0;                    ///< the terms from c_1 on: zero at the start
    double higherSize = 0;
    double integral = 0;    ///< of all
    double stored = 0;      ///< what the rounding of the coefficients is relative to, over [0, x]
    double integrated = 0;  ///< and that of the integral

    /// `decay` is e^{−λx}.
    DecaysEnd(const Coefficients& terms, double rate, double x, double decay);

    double value() const { return first * firstDecay + higher; }
    double valueSize() const { return std::abs(first) * firstDecay + higherSize; }
    /// From the start on.
    double change() const { return higher - first * firstRise; }
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
    constexpr double lasting = Coefficients::capacity;  // for so many 1/λ at most a term is that large
    integral = risen / rate;
    stored = largest * std::min(x, lasting / rate);
    integrated = sizes * std::min(x, 1 / rate);
}

}  // namespace drillwave
