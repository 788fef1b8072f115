// SPDX-License-Identifier: GPL-3.0-or-later
// Solution of a blow on a drill string whose sections may be cones, which are replaced by uniform pieces.
#pragma once

#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/network/network_solver.h"

namespace drillwave {

/// Result of a blow on a drill string, with the dimensionless problem that was solved.
struct ChainSolution {
    Problem problem;
    Impact impact;
};

/// Returns the solution of a blow on a drill string. Each conical section is replaced by uniform pieces.
/// Their number is doubled until coefficient of restitution and efficiency hardly change, or the work limit
/// is near. The error that the pieces cause is proportional to the square of their length. The stated errors
/// contain twice the last change, or more if earlier changes were larger. If the largest forces take too much
/// work for so many pieces, all results are those for fewer pieces. If the waves are too many to be kept,
/// only the waves are those for fewer pieces.
ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop = {});

}  // namespace drillwave
