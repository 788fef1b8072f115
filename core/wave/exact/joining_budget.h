// SPDX-License-Identifier: GPL-3.0-or-later
// How much joined wave pieces may cost, from how much they save.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/wave/problem.h"

namespace drillwave {

/// The bounds of joining for one blow, in double precision. A contact with soft rock lasts about 1.6/√(βτ)
/// round trips, or 1.6/√β with small γ, where the front end comes back at every pass of the blow alone. Each
/// leaves its kinks, and every later one passes them: work grows with the square of the trips. From hundreds
/// of trips on e is given fewer digits for that.
struct JoiningBudget {
    double passes = 1;         ///< about as many times a piece of wave meets the rock, ≥ 1
    double smoothEffect = 0;   ///< of one joint on the impulse in all passes, without events in it
    double mostDisplaced = 0;  ///< of the way of the bit by one joint, I0
    double mostDeviation = 0;  ///< of the wave force, F0
    double loadingWeight = 1;  ///< of an impulse displaced before the last peak on that of the rebound

    explicit JoiningBudget(const Problem& problem) {
        const double gamma = problem.law.gamma, tau = problem.transitTime();
        // of the steepest loading line, and of the least steep one
        double beta = problem.law.firstSlope * problem.law.beta, softest = beta;
        for (const LawCorner& corner : problem.law.corners) {
            beta = std::max(beta, corner.slope * problem.law.beta);
            softest = std::min(softest, corner.slope * problem.law.beta);
        }
        const double trips = std::max(1.0, 1.6 / std::sqrt(softest * tau));
        passes =
            std::max(1.0, 1.6 / std::sqrt(softest * std::clamp(100 * gamma * tau, std::min(tau, 1.0), tau)));
        const double excess = std::pow(std::max(1.0, passes / fewPasses), 6);
        const double share = std::min(1.0, leastError / mostError * excess);
        const double error = share * mostError;
        smoothEffect = error / passes;
        // A peak of the way that errs by D displaces √(βτ/γ) D while the rod is thrown back, D at most. With
        // the peaks of all trips it is some sixteen times that, from hundreds on growing with the trips; more
        // where γ is larger, and work no matter.
        const double perDisplacement = std::min(1.0, std::sqrt(beta * tau / gamma));
        const double peaks = std::max(16.0, trips / 12) * std::clamp(2000 * gamma, 1.0, 4.0);
        mostDisplaced = error / (perDisplacement * peaks);
        const double waveForce = std::max(problem.force().peak, 1 / (2 * tau));
        mostDeviation = 1e-9 * std::min(waveForce, std::sqrt(softest / tau)) + 1e-5 * waveForce * share;
        loadingWeight = std::sqrt(gamma);
    }

  private:
    static constexpr double fewPasses = 100;     ///< cheap, whatever each leaves
    static constexpr double leastError = 1e-15;  ///< of e, up to so many
    static constexpr double mostError = 5e-10;   ///< of e, however many there are
};

}  // namespace drillwave
