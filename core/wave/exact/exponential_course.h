// SPDX-License-Identifier: GPL-3.0-or-later
// How an exponential sum runs over its length, by bounds: what makes most searches for an event needless.
#pragma once

#include <algorithm>

#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Bounds of the slope and of the curvature of a sum over its whole length: each holds, and may be wide.
struct ExponentialCourse {
    double leastSlope = 0, mostSlope = 0;
    double leastCurvature = 0, mostCurvature = 0;

    template <int lines>
    explicit ExponentialCourse(const ExponentialSum<lines>& f);

    bool falls() const { return mostSlope <= 0; }
    bool rises() const { return leastSlope >= 0; }
    bool isConvex() const { return leastCurvature >= 0; }
    bool isConcave() const { return mostCurvature <= 0; }

  private:
    void addTerms(const Coefficients& decays, const Coefficients& rises, double rate);
    void addHammer(const HammerTerms& hammer, double length);
};

/// An upper bound of ∫f over [0, x] for every x up to the length, and 0, from the values at the ends and that
/// over the `whole`: a convex function lies below its chord, and others above it by no more than their
/// curvature bends them.
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

/// The slope of Σ c_m φ_m + Σ q_m ω_m is Σ (c_{m+1} − c_m + q_m) φ_m, times the rate; no φ_m is negative, and
/// together they are at most 1.
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
