// SPDX-License-Identifier: GPL-3.0-or-later
// What a response in closed form comes to at the end of a stretch of contact, and how far that may be wrong.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/wave/exact/exponential_terms.h"

namespace drillwave {

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
