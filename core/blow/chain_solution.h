// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a string of any kinds of sections: uniform pieces stand for those that are not.
#pragma once

#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/network/network_solver.h"

namespace drillwave {

/// The problem that was solved, and its result.
struct ChainSolution {
    Problem problem;
    Impact impact;
};

/// Solves a blow on a string. Sections that are not uniform become more pieces until half as many make no
/// difference to e and efficiency that is worth it, as far as the work that is permitted allows. The error of
/// the pieces falls with the square of their lengths; the stated errors contain twice the last change, or
/// more where the changes before were larger. Where the largest forces take too much work for so many pieces,
/// the result is that of fewer; where the waves are more than can be kept, they are those of fewer.
ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop = {});

}  // namespace drillwave
