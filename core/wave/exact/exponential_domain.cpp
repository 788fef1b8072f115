// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_domain.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

// In its domain the basis may still fail and be replaced, but mostly it solves what series solve, several
// times as fast; the numbers are where that ends.

/// γ < 1: terms of the other rate are divided by 1 − γ at every reflection. From 0.9 on none is solved.
constexpr double largestGamma = 0.7;

/// Nearer to 1 where contact ends within a round trip, so that few reflections divide by 1 − γ.
constexpr double largestStiffGamma = 0.9, leastStiffDecay = 3;

/// βτ and β below which so many fail, or state too large an error, that trying costs more than it saves.
/// Contact lasts about 1.6/√(βτ) round trips, each of which needs another of the few terms.
struct Stiffness {
    double decay, beta;
};
constexpr Stiffness leastForElasticSteps{0.2, 0.01}, leastForSteps{0.55, 0.01}, leastForCurves{0.3, 0.15},
    leastForRamps{1, 0.4};
constexpr Stiffness leastForTables{3, 1.5};  ///< dozens of ramps, many of them steep

/// Pulses of fewer linear pieces are those of a formula.
constexpr std::size_t leastTable = 12;

Stiffness leastFor(const PulseForce& hammer, bool isElastic) {
    using Kind = PulseSegment::Kind;
    const auto& segments = hammer.segments;
    const Stiffness& steps = isElastic ? leastForElasticSteps : leastForSteps;
    if (segments.empty()) return steps;
    if (segments.front().kind != Kind::linear) return leastForCurves;
    const bool isSteps = std::all_of(segments.begin(), segments.end(),
                                     [](const PulseSegment& segment) { return segment.slope == 0; });
    if (isSteps) return steps;
    return segments.size() < leastTable ? leastForRamps : leastForTables;
}

/// Each is a piece that all reflections repeat, and most of them are short where there are many.
constexpr std::size_t mostSegments = 1000;

/// β and β/γ beside the rate of an exponential blow, 1/t0: the response is divided by the difference.
constexpr double leastDetuning = 0.1;

}  // namespace

bool suitsExponentials(const Problem& problem) {
    const double beta = problem.law.beta, gamma = problem.law.gamma;
    const double decay = beta * problem.transitTime();
    if (decay < leastForElasticSteps.decay || beta < leastForElasticSteps.beta) return false;
    if (gamma < 1 && gamma > (decay < leastStiffDecay ? largestGamma : largestStiffGamma)) return false;
    if (problem.force().segments.size() > mostSegments) return false;
    const Stiffness least = leastFor(problem.force(), gamma == 1);
    if (decay < least.decay || beta < least.beta) return false;
    if (problem.force().shape == PulseShape::exponential) {
        const auto isDetuned = [](double rate) { return std::abs(rate - 1) > leastDetuning; };
        return isDetuned(beta) && isDetuned(beta / gamma);
    }
    return true;
}

}  // namespace drillwave
