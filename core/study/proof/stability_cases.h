// SPDX-License-Identifier: GPL-3.0-or-later
// The stiff and extreme cases on which the exact solver is held to account.
#pragma once

#include <string>
#include <vector>

#include "core/wave/problem.h"

namespace drillwave {

/// A case, with the reason for it.
struct StabilityCase {
    std::string name;
    PulseShape shape = PulseShape::rectangular;
    double impedanceRatio = 2;  ///< of a piston
    Groups groups;
    bool operator==(const StabilityCase&) const = default;
};

/// Returns the case as a scenario of its groups, with its name.
Scenario scenarioOf(const StabilityCase& stabilityCase);

/// Returns the problem to solve in a case.
Problem problemOf(const StabilityCase& stabilityCase);

/// The published cases; the known traps (forceless contact, tangential events, equal and nearly equal rates,
/// many reflections, stiff layers, gaps that close with a front, forces that turn with one, a hammer that
/// pushes during several reflections, slow drift); short rods under every shape; chattering bits; each
/// parameter through its whole range (β 1e-9 … 1e12, γ 1e-9 … 1, τ 0.01 … 1e4, δ … 1e6) from a soft, a middle
/// and a stiff case; and a product grid of extremes for every pulse shape.
///
/// Left out, because it needs more wave pieces than the solver permits (30 million): β < 1e-6 together with
/// γ < 1, where a contact lasts 1.6/√(βτ) round trips and each leaves kinks that never vanish; and τ < 0.1
/// with exponential and piston blows, during which every front passes the rock up to 2000 times.
std::vector<StabilityCase> stabilityCases();

}  // namespace drillwave
