// SPDX-License-Identifier: GPL-3.0-or-later
// Which uncertain number an output depends on: Sobol indices.
#pragma once

#include <cstdint>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/study/design/design_problem.h"
#include "core/text/message.h"

namespace drillwave {

/// Shares of the variance of an output: by one uncertain number only, and including effects with others.
struct SobolIndex {
    Estimate first;
    Estimate total;
};

/// Sensitivities of one output.
struct OutputSensitivity {
    bool isConstant = false;          ///< the output does not scatter: there are no indices
    std::vector<SobolIndex> indices;  ///< of each uncertain number
};

struct Sensitivity {
    std::vector<OutputSensitivity> outputs;  ///< in the order requested; none after a stop
    std::uint64_t unsolved = 0;              ///< points left out, with all that are compared with them
    Message reason;
};

/// Returns the number of solves of sensitivityOf() for d uncertain numbers.
std::uint64_t sensitivitySolves(std::size_t uncertain, std::uint64_t samples);

/// Indices of the outputs named by number, of one design, from points in 2d dimensions (A, B, and A with
/// coordinate i of B):
///
///     S_i = (1/n) Σ f(B)[f(AB_i) − f(A)] / V       (Saltelli 2010)
///     T_i = (1/2n) Σ [f(A) − f(AB_i)]² / V         (Jansen 1999)
///
/// f centred by the mean of A and B, V the variance of both; by replicates, with the error of their mean. A
/// single uncertain number has S = T = 1. `samples` is as in SampleOrder.
Sensitivity sensitivityOf(const DesignProblem& problem, std::uint64_t design,
                          const std::vector<std::size_t>& outputs, std::uint64_t samples, std::uint64_t seed,
                          const DesignWork& work);

}  // namespace drillwave
