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
/// is near. The error of this replacement is proportional to the square of the length of a piece. The stated
/// errors contain twice the last change, or more if earlier changes were larger. If computing the largest
/// forces takes too much work with the final number of pieces, all results are those with fewer pieces. If
/// only the waves are too many to be kept, the waves are those with fewer pieces.
ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop = {});

}  // namespace drillwave
