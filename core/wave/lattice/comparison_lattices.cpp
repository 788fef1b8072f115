// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/lattice/comparison_lattices.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

constexpr int latticeCount = 8;
constexpr std::size_t leastAligned = 4;

/// Whether the force jumps after its beginning.
bool hasJumps(const PulseForce& pulse) {
    switch (pulse.shape) {
        case PulseShape::rectangular:
        case PulseShape::piston:
            return true;
        case PulseShape::table:
            return pulse(std::nextafter(pulse.end, 0)) > 1e-9 * pulse.peak;
        default:
            return false;
    }
}

/// How far on a circle the steps of a lattice are from having t0 at the fraction `phase` of one.
double phaseDistance(int segments, double tau, double phase) {
    const double away = segments / tau - phase;
    return std::abs(away - std::round(away));
}

/// A number of segments at most `radius` away whose steps have t0 at that fraction, or nearly so.
int nearWithPhase(int segments, int radius, double tau, double phase, double tolerance) {
    int best = segments;
    for (int away = 0; away <= radius; ++away)
        for (const int candidate : {segments - away, segments + away}) {
            if (phaseDistance(candidate, tau, phase) < phaseDistance(best, tau, phase)) best = candidate;
            if (phaseDistance(best, tau, phase) <= tolerance) return best;
        }
    return best;
}

}  // namespace

std::vector<int> comparisonLattices(const Problem& problem, int segments) {
    // Ratios without a pattern: corners of the law fall on any fractions.
    constexpr double shares[latticeCount] = {0.4127, 0.7291, 0.5503, 0.4619, 0.6413, 0.5099, 0.6867, 0.5923};
    constexpr double exact = 1e-6, rough = 1.0 / 32;
    const int radius = segments / 40;
    const double tau = problem.transitTime();
    const bool jumps = hasJumps(problem.force());
    const bool isAligned = jumps && phaseDistance(segments, tau, 0) <= exact;
    std::vector<int> spread, aligned;
    for (int i = 0; i < latticeCount; ++i) {
        const int target = std::max(1, static_cast<int>(shares[i] * segments));
        spread.push_back(jumps ? nearWithPhase(target, radius, tau, double(i) / latticeCount, rough)
                               : target);
        if (!isAligned) continue;
        const int candidate = nearWithPhase(target, radius, tau, 0, exact);
        if (phaseDistance(candidate, tau, 0) <= exact && std::ranges::count(aligned, candidate) == 0)
            aligned.push_back(candidate);
    }
    return aligned.size() >= leastAligned ? aligned : spread;
}

}  // namespace drillwave
