// SPDX-License-Identifier: GPL-3.0-or-later
// The blows that the paper's figures show.
#pragma once

#include <functional>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Figs 3–5 and 8: β = 0.5, τ = 10, no gap.
inline constexpr Groups paperElastic{0.5, 1, 10, 0};
inline constexpr Groups paperBilinear{0.5, 0.1, 10, 0};

/// Range of β in Figs 6 and 7.
inline constexpr double paperLeastBeta = 0.1;
inline constexpr double paperMostBeta = 10;

/// The rectangular blow, or the rod that arrives without waves.
Problem paperProblem(const Groups& groups, PulseShape shape = PulseShape::rectangular);

/// Solves one of them exactly.
Impact solvePaperCase(const Groups& groups, Detail detail, PulseShape shape = PulseShape::rectangular);

/// e of the rectangular blow; NaN if it could not be solved.
double paperCor(const Groups& groups);

/// Returns e without a gap, over β.
double corAtBeta(double beta, double gamma = 1, double tau = paperElastic.tau);

/// Meaning of β = 1 in the reference case, whose result depends only on βτ.
enum class ReferenceStiffness {
    roundTrip,  ///< k0 = Z/(2T): the paper's reference curves, its condition of equal work, τ = 1/2
    pulse,      ///< k0 = Z/t0 as in the paper's section 5.1, here at τ = 10
};

/// e of the reference case; NaN if it could not be solved.
double referenceCor(double beta, double gamma, ReferenceStiffness stiffness);

/// An extreme of a result over β.
struct BetaExtreme {
    double beta;
    double cor;
};

/// The largest value of `sign` times cor(β) for β from 0.001 to 100, by Brent's method in log β around the
/// best point of a grid; β to about 1e-7.
BetaExtreme extremeOverBeta(const std::function<double(double)>& cor, double sign);

}  // namespace drillwave
