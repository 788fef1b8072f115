// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the course of an exponential sum over its length, which make most searches for events needless.
#pragma once

#include <algorithm>

#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Lower and upper bounds of slope and curvature of an exponential sum over its whole length. The true values
/// are certainly within them, but may be far from them.
struct ExponentialCourse {
    /// Lower and upper bound of the slope of the exponential sum over its whole length, in units of F0/t0.
    double leastSlope = 0, mostSlope = 0;
    /// Lower and upper bound of the curvature (second derivative) of the exponential sum over its whole
    /// length, in units of F0/t0².
    double leastCurvature = 0, mostCurvature = 0;

    template <int lines>
    explicit ExponentialCourse(const ExponentialSum<lines>& f);

    /// Returns whether the exponential sum certainly does not increase anywhere on its interval; false if
    /// that is not known.
    bool falls() const { return mostSlope <= 0; }
    /// Returns whether the exponential sum certainly does not decrease anywhere on its interval; false if
    /// that is not known.
    bool rises() const { return leastSlope >= 0; }
    /// Returns whether the exponential sum is certainly convex on its interval; false if that is not known.
    bool isConvex() const { return leastCurvature >= 0; }
    /// Returns whether the exponential sum is certainly concave on its interval; false if that is not known.
    bool isConcave() const { return mostCurvature <= 0; }

  private:
    void addTerms(const Coefficients& decays, const Coefficients& rises, double rate);
    void addHammer(const HammerTerms& hammer, double length);
};

/// Returns an upper bound, at least 0, of ∫f over [0, x] for every x within the interval of f, in units of
/// I0. It uses the values of f at both ends, a bound of its curvature, and `whole`, its integral over the
/// whole interval.
template <int lines>
double mostIntegralByEnds(const ExponentialSum<lines>& f, double whole);

template <int lines>
inline ExponentialCourse::ExponentialCourse(const ExponentialSum<lines>& f) {
    eachLine<lines>([&](int i) {
        if (f.hasLine(i)) addTerms(f.decays[i], f.risesOf(i), (*f.rates)[i]);
    });
    if (!f.isCurved) return;
    leastSlope += f.curve.c1;
    mostSlope += f.curve.c1;
    if (f.hasHammer()) addHammer(f.curve.hammer, f.length);
}

/// Adds the bounds for the terms Σ c_m φ_m + Σ q_m ω_m of one rate λ. Their slope is λ Σ (c_{m+1} − c_m +
/// q_m) φ_m. No φ_m is negative, and their sum is at most 1.
inline void ExponentialCourse::addTerms(const Coefficients& decays, const Coefficients& rises, double rate) {
    double next = 0, nextSlope = 0;
    double lowSlope = 0, highSlope = 0, lowBend = 0, highBend = 0;
    for (int m = std::max(decays.count, rises.count) - 1; m >= 0; --m) {
        const double decay = decays[m], slope = next - decay + rises[m], bend = nextSlope - slope;
        lowSlope = std::min(lowSlope, slope);
        highSlope = std::max(highSlope, slope);
        lowBend = std::min(lowBend, bend);
        highBend = std::max(highBend, bend);
        next = decay;
        nextSlope = slope;
    }
    leastSlope += rate * lowSlope;
    mostSlope += rate * highSlope;
    leastCurvature += rate * rate * lowBend;
    mostCurvature += rate * rate * highBend;
}

}  // namespace drillwave
