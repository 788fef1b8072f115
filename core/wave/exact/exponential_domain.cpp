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

/// The same of the softest line where the loading has a corner: three rates leave more terms than two. How
/// near each other they are hardly matters.
constexpr Stiffness leastForCornerSteps{0.5, 0.1}, leastForCornerDecays{0.2, 0.05},
    leastForCornerCurves{1, 0.4};

/// Pulses of fewer linear pieces are those of a formula.
constexpr std::size_t leastTable = 12;

/// Least distance of the slopes from the rate of an exponential blow, 1/t0: the response is divided by it.
constexpr double leastDetuning = 0.1;

/// Returns the least stiffness for a blow: its kind of segments decides how many terms it leaves.
Stiffness leastFor(const PulseForce& hammer, const BitRockLaw& law) {
    using Kind = PulseSegment::Kind;
    const auto& segments = hammer.segments;
    const bool isSteps = std::ranges::all_of(segments, [](const PulseSegment& segment) {
        return segment.kind == Kind::linear && segment.slope == 0;
    });
    if (isSteps && !law.corners.empty()) return leastForCornerSteps;
    if (isSteps) return law.gamma == 1 ? leastForElasticSteps : leastForSteps;
    if (segments.size() >= leastTable) return leastForTables;
    if (!law.corners.empty())
        return hammer.shape == PulseShape::exponential ? leastForCornerDecays : leastForCornerCurves;
    return segments.front().kind == Kind::linear ? leastForRamps : leastForCurves;
}

/// Whether the rate of an exponential blow, 1/t0, is off those of all lines.
bool isDetuned(const BitRockLaw& law) {
    const auto isOff = [](double rate) { return std::abs(rate - 1) > leastDetuning; };
    return isOff(law.firstSlope * law.beta) && isOff(law.beta / law.gamma) &&
           std::ranges::all_of(law.corners,
                               [&](const LawCorner& corner) { return isOff(corner.slope * law.beta); });
}

/// Each is a piece that all reflections repeat, and most of them are short where there are many.
constexpr std::size_t mostSegments = 1000;

}  // namespace

bool suitsExponentials(const Problem& problem) {
    const BitRockLaw& law = problem.law;
    const double gamma = law.gamma;
    double softest = law.firstSlope * law.beta;
    for (const LawCorner& corner : law.corners) softest = std::min(softest, corner.slope * law.beta);
    const double decay = softest * problem.transitTime();
    if (decay < leastForElasticSteps.decay || softest < leastForElasticSteps.beta) return false;
    if (law.corners.size() > mostCornersOfSums) return false;
    if (gamma < 1 && gamma > (decay < leastStiffDecay ? largestGamma : largestStiffGamma)) return false;
    if (problem.force().segments.size() > mostSegments) return false;
    const Stiffness least = leastFor(problem.force(), law);
    if (decay < least.decay || softest < least.beta) return false;
    return problem.force().shape != PulseShape::exponential || isDetuned(law);
}

}  // namespace drillwave
