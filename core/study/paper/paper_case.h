// SPDX-License-Identifier: GPL-3.0-or-later
// Blows that the figures of the paper show.
#pragma once

#include <functional>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Parameters of Figs 3–5 and 8 of the paper: β = 0.5, γ = 1 (elastic) or 0.1 (bilinear), τ = 10, no gap.
inline constexpr Groups paperElastic{0.5, 1, 10, 0};
inline constexpr Groups paperBilinear{0.5, 0.1, 10, 0};

/// Least and largest dimensionless stiffness β in Figs 6 and 7 of the paper.
inline constexpr double paperLeastBeta = 0.1;
inline constexpr double paperMostBeta = 10;

/// Returns the dimensionless problem of a blow in the paper. The rod is loaded by a rectangular hammer
/// force, or arrives without waves in the reference case (PulseShape::rigidBody).
Problem paperProblem(const Groups& groups, PulseShape shape = PulseShape::rectangular);

/// Returns the exact solution of a blow in the paper. `detail` selects how many results are computed.
Impact solvePaperCase(const Groups& groups, Detail detail, PulseShape shape = PulseShape::rectangular);

/// Returns the coefficient of restitution e of a blow by a rectangular hammer force; NaN if it could not be
/// solved.
double paperCor(const Groups& groups);

/// Returns the coefficient of restitution e of a rod under a rectangular hammer force, with no gap between
/// bit and rock. `beta` is the dimensionless stiffness β, `gamma` the elasticity γ of the rock and `tau` the
/// transit time τ of the rod. NaN if the blow could not be solved.
double corAtBeta(double beta, double gamma = 1, double tau = paperElastic.tau);

/// Reference stiffness k0 in β = k/k0 for the reference case, a rod that arrives with uniform velocity and
/// no waves. The coefficient of restitution of this case depends only on γ and βτ.
enum class ReferenceStiffness {
    roundTrip,  ///< k0 = Z/(2T), as in the paper's reference curves: equal work, τ = 1/2
    pulse,      ///< k0 = Z/t0, as in section 5.1 of the paper, computed for τ = 10
};

/// Returns the coefficient of restitution e of the reference case (rod without waves); NaN if it could not be
/// solved.
double referenceCor(double beta, double gamma, ReferenceStiffness stiffness);

/// Extreme of a result over the dimensionless stiffness β.
struct BetaExtreme {
    double beta;
    double cor;
};

/// Returns the β from 0.001 to 100 at which cor(β) is largest (`sign` = 1) or smallest (`sign` = −1), with
/// the value of cor. Found by Brent's method in log β around the best point of a grid; β is accurate to about
/// 1e-7.
BetaExtreme extremeOverBeta(const std::function<double(double)>& cor, double sign);

}  // namespace drillwave
