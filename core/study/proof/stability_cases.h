// SPDX-License-Identifier: GPL-3.0-or-later
// Stiff and extreme cases with which the exact solver is tested.
#pragma once

#include <string>
#include <vector>

#include "core/wave/problem.h"

namespace drillwave {

/// Test case of the exact solver. Its name describes what makes the case difficult or important.
struct StabilityCase {
    std::string name;
    PulseShape shape = PulseShape::rectangular;
    double impedanceRatio = 2;  ///< hammer impedance over rod impedance, for a piston hammer only
    Groups groups;
    bool operator==(const StabilityCase&) const = default;
};

/// Returns the dimensionless scenario of a test case, with the name of the case as its title.
Scenario scenarioOf(const StabilityCase& stabilityCase);

/// Returns the dimensionless problem of the blow that is solved in a test case.
Problem problemOf(const StabilityCase& stabilityCase);

/// Returns all test cases of the exact solver, which include the published ones and known difficulties.
/// Difficulties are contact without force, tangential events, equal and nearly equal rates, many reflections,
/// and stiff layers, in which the force changes very fast. Others are gaps that close as a front arrives,
/// forces that reverse as a front arrives, a hammer force lasting several reflections, and slow drift. Short
/// rods under every pulse shape and chattering bits are included too.
/// Each parameter is varied over its whole range, starting from a soft, a medium and a stiff case. The ranges
/// are β 1e-9 … 1e12, γ 1e-9 … 1, τ 0.01 … 1e4 and δ up to 1e6. For every pulse shape, the extremes of all
/// parameters are combined.
/// Two kinds of cases are left out because they need more than the permitted 30 million wave pieces (the
/// solver's unit of work). One kind is β < 1e-6 with γ < 1: a contact lasts 1.6/√(βτ) round trips, and each
/// adds kinks that never vanish. The other is τ < 0.1 with exponential and piston blows, during which every
/// front passes the rock up to 2000 times.
std::vector<StabilityCase> stabilityCases();

}  // namespace drillwave
