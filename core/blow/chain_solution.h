// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a string of any kinds of sections: uniform pieces stand for those that are not.
#pragma once

#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/network/network_solver.h"

namespace drillwave {

/// What was solved, and what came of it.
struct ChainSolution {
    Problem problem;
    Impact impact;
};

/// Solves a blow on a string. Sections that are not uniform become more pieces until half as many make no
/// difference to e and efficiency that is worth it, as far as the work that is permitted allows; what they
/// still make is in the stated errors: some six times what is left, which falls with the square of the
/// pieces.
ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop = {});

}  // namespace drillwave
