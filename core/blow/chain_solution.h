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

/// Solves a blow on a string. Sections that are not uniform are split into more pieces until half as many
/// give nearly the same e and efficiency, as far as the permitted work allows. The error of the pieces falls
/// with the square of their lengths; the stated errors contain twice the last change, or more where the
/// changes before were larger. Where the largest forces of so many pieces take too much work, the result has
/// fewer pieces; where the waves are more than can be kept, they are those of fewer pieces.
ChainSolution solveChain(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                         const std::stop_token& stop = {});

}  // namespace drillwave
