// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/paper/paper_case.h"

#include <cmath>
#include <limits>

#include "core/numeric/brent.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

namespace {

double corOf(const Impact& impact) {
    return impact.outcome == Outcome::rebounded ? impact.cor : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Problem paperProblem(const Groups& groups, PulseShape shape) {
    return problemOf(pulseForceOf(shape), groups);
}

Impact solvePaperCase(const Groups& groups, Detail detail, PulseShape shape) {
    return ExactSolver().solve(paperProblem(groups, shape), detail);
}

double paperCor(const Groups& groups) {
    return corOf(solvePaperCase(groups, Detail::cor));
}

double corAtBeta(double beta, double gamma, double tau) {
    return paperCor({beta, gamma, tau, 0});
}

double referenceCor(double beta, double gamma, ReferenceStiffness stiffness) {
    const double tau = stiffness == ReferenceStiffness::roundTrip ? 0.5 : paperElastic.tau;
    return corOf(solvePaperCase({beta, gamma, tau, 0}, Detail::cor, PulseShape::rigidBody));
}

BetaExtreme extremeOverBeta(const std::function<double(double)>& cor, double sign) {
    constexpr double least = -3, step = 0.1;  // log10 β
    constexpr int points = 51;
    const auto negative = [&](double logarithm) { return -sign * cor(std::pow(10, logarithm)); };
    int best = 0;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < points; ++i)
        if (const double value = negative(least + i * step); value < lowest) {
            lowest = value;
            best = i;
        }
    const double middle = least + best * step;
    const Minimum found = brentMinimum(negative, middle - step, middle + step);
    return {std::pow(10, found.x), -sign * found.value};
}

}  // namespace drillwave
