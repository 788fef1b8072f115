// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_course.h"

#include <limits>

namespace drillwave {

void ExponentialCourse::addHammer(const HammerTerms& hammer, double length) {
    constexpr double pi = HammerTerms::pi;
    const double decay = hammer.decay;
    leastSlope += std::min(-decay, 0.0);
    mostSlope += std::max(-decay, 0.0);
    leastCurvature += std::min(decay, 0.0);
    mostCurvature += std::max(decay, 0.0);
    if (!hammer.hasSine()) return;
    const HammerTerms wave{hammer.sine, hammer.cosine, 0, true};
    const HammerTerms slope{-hammer.cosine, hammer.sine, 0, true};
    if (!slope.allAtLeastZero(length)) leastSlope -= pi * wave.amplitude();
    if (!slope.allAtMostZero(length)) mostSlope += pi * wave.amplitude();
    if (!wave.allAtMostZero(length)) leastCurvature -= pi * pi * wave.amplitude();
    if (!wave.allAtLeastZero(length)) mostCurvature += pi * pi * wave.amplitude();
}

namespace {

/// A lower bound of the curvature of Σ c_m φ_m(λx), and of 0: λ² Σ (c_{m+2} − 2c_{m+1} + c_m) φ_m. Whoever
/// wants no more of a sum of steps saves a third beside ExponentialCourse.
double leastCurvature(const Coefficients& decays, double rate) {
    double next = 0, afterNext = 0, least = 0;
    for (int m = decays.count - 1; m >= 0; --m) {
        const double c = decays.c[m];
        least = std::min(least, (afterNext - next) - (next - c));
        afterNext = next;
        next = c;
    }
    return rate * rate * least;
}

template <int lines>
double leastCurvature(const ExponentialSum<lines>& f) {
    if (f.isCurved) return ExponentialCourse(f).leastCurvature;
    double least = 0;
    eachLine<lines>([&](int i) {
        if (f.decays[i].count) least += leastCurvature(f.decays[i], (*f.rates)[i]);
    });
    return least;
}

}  // namespace

template <int lines>
double mostIntegralByEnds(const ExponentialSum<lines>& f, double whole) {
    const double length = f.length;
    const double bow = -std::min(leastCurvature(f), 0.0) * length * length * length / 12;
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * f.magnitude() * length;
    const double start = f.startValue();
    if (start <= 0) return std::max(bow, whole) + rounding;
    const double end = f.value(length);
    const double underChord = end >= 0 ? (start + end) / 2 : start * start / (2 * (start - end));
    return underChord * length + bow + rounding;
}

template double mostIntegralByEnds(const ExponentialSum<2>&, double);
template double mostIntegralByEnds(const ExponentialSum<3>&, double);

}  // namespace drillwave
