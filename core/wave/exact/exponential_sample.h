// SPDX-License-Identifier: GPL-3.0-or-later
// An exponential sum at one point, as the search for its first zero looks at it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wave/exact/exponential_algebra.h"
#include "core/wave/exact/exponential_end.h"

namespace drillwave {

/// The slope c + Σ d_m φ_m(λx) over the rates of an exponential sum, but for its hammer terms.
template <int lines>
struct ExponentialSlope {
    double constant = 0;
    TermsOfLines<lines> decays;

    explicit ExponentialSlope(const ExponentialSum<lines>& f) {
        eachLine<lines>([&](int i) { differences(f.decays[i], (*f.rates)[i], decays[i]); });
        if (!f.isCurved) return;
        constant = f.curve.c1;
        eachLine<lines>([&](int i) { addRises(f.curve.rises[i], (*f.rates)[i], decays[i]); });
    }

  private:
    /// That of Σ q_m ω_m is Σ q_m φ_m, times the rate.
    static void addRises(const Coefficients& rises, double rate, Coefficients& slope) {
        const int common = std::min(slope.count, rises.count);
        for (int m = 0; m < common; ++m) slope.c[m] += rate * rises.c[m];
        for (int m = common; m < rises.count; ++m) slope.c[m] = rate * rises.c[m];
        slope.count = std::max(slope.count, rises.count);
    }
};

/// A function at one point, with a lower bound of its curvature from there on.
struct ExponentialSample {
    double value = 0, slope = 0, curvature = 0, leastCurvature = 0;
    double size = 0;     ///< what the rounding of `value` is relative to
    double fastest = 0;  ///< the largest rate in it

    double noise() const { return 4 * std::numeric_limits<double>::epsilon() * size; }
};

/// Adds the terms of one rate, of which `slopes` are the slope.
[[gnu::always_inline]] inline void addTerms(const Coefficients& decays, const Coefficients& rises,
                                            const Coefficients& slopes, double rate, double x,
                                            ExponentialSample& s) {
    const double y = rate * x;
    const double decay = x == 0 ? 1.0 : std::exp(-y);
    double bend = 0, leastBend = 0, size = 0, phi = decay;
    for (int m = 0; m < slopes.count; ++m) {
        if (m < decays.count) {
            s.value += decays.c[m] * phi;
            size += std::abs(decays.c[m]) * phi;
        }
        const double slope = slopes.c[m], curvature = slopes[m + 1] - slope;
        s.slope += slope * phi;
        bend += curvature * phi;
        if (curvature < 0) leastBend += curvature * (y >= m ? phi : largestDecays[m]);
        phi *= y / (m + 1);
    }
    if (rises.count && x > 0) {
        s.value += rises.rises(y, decay);
        size += rises.magnitude() * std::min(y, 1.0);
    }
    s.curvature += rate * bend;
    s.leastCurvature += rate * leastBend;
    s.size += size * (1 + y);
    s.fastest = std::max(s.fastest, rate);
}

/// `amplitude` is that of the sine.
inline void addHammer(const HammerTerms& f, double amplitude, double x, ExponentialSample& s) {
    constexpr double pi = HammerTerms::pi;
    if (f.hasSine()) {
        const double sine = std::sin(pi * x), cosine = std::cos(pi * x);
        const double value = f.sine * sine + f.cosine * cosine;
        s.value += value;
        s.slope += pi * (f.sine * cosine - f.cosine * sine);
        s.curvature -= pi * pi * value;
        s.leastCurvature -= pi * pi * amplitude;
        s.size += f.amplitude();
        s.fastest = std::max(s.fastest, pi);
    }
    if (f.decay != 0) {
        const double value = f.decay * std::exp(-x);
        s.value += value;
        s.slope -= value;
        s.curvature += value;
        s.leastCurvature += std::min(value, 0.0);
        s.size += std::abs(value) * (1 + x);
        s.fastest = std::max(s.fastest, 1.0);
    }
}

/// f + c2 x², as it is searched.
template <int lines>
struct SearchedSum {
    const ExponentialSum<lines>& f;
    double c2;
    ExponentialSlope<lines> slope{f};
    double amplitude = f.hasHammer() ? std::hypot(f.curve.hammer.sine, f.curve.hammer.cosine) : 0;

    ExponentialSample at(double x) const;
};

template <int lines>
inline ExponentialSample SearchedSum<lines>::at(double x) const {
    ExponentialSample s;
    s.value = f.c0;
    s.size = std::abs(f.c0);
    if (f.isCurved || c2 != 0) {
        s.value += x * (slope.constant + x * c2);
        s.slope = slope.constant + 2 * c2 * x;
        s.curvature = s.leastCurvature = 2 * c2;
        s.size += std::abs(slope.constant) * x + std::abs(c2) * x * x;
    }
    eachLine<lines>([&](int i) {
        if (slope.decays[i].count) addTerms(f.decays[i], f.risesOf(i), slope.decays[i], (*f.rates)[i], x, s);
    });
    if (f.hasHammer()) addHammer(f.curve.hammer, amplitude, x, s);
    return s;
}

}  // namespace drillwave
