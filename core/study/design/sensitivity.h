// SPDX-License-Identifier: GPL-3.0-or-later
// Sobol indices: how much of an output's variance each uncertain input causes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/study/design/design_problem.h"
#include "core/text/message.h"

namespace drillwave {

/// Sobol indices of one uncertain input: shares of the variance of an output. `first` counts only the effect
/// of this input, `total` also its interactions with others.
struct SobolIndex {
    Estimate first;
    Estimate total;
};

/// Sensitivity of one output of a design to all uncertain inputs.
struct OutputSensitivity {
    bool isConstant = false;          ///< whether the output does not vary; `indices` is then empty
    std::vector<SobolIndex> indices;  ///< Sobol indices of each uncertain input, in the order of the inputs
};

struct Sensitivity {
    /// Sensitivity of each requested output, in the order of the request; empty after a stop request.
    std::vector<OutputSensitivity> outputs;
    /// Number of samples left out, because their blow or a blow compared with it could not be solved.
    std::uint64_t unsolved = 0;
    Message reason;
};

/// Returns the number of blows that sensitivityOf() solves, for a number of uncertain inputs and of samples.
std::uint64_t sensitivitySolves(std::size_t uncertain, std::uint64_t samples);

/// Returns the Sobol indices of the outputs (given by index) of one design. Uses points in 2d dimensions for
/// d uncertain inputs: two sets A and B, and A_Bi, which is A with coordinate i taken from B:
///
///     S_i = (1/n) Σ f(B)[f(A_Bi) − f(A)] / V       (Saltelli 2010)
///     T_i = (1/2n) Σ [f(A) − f(A_Bi)]² / V         (Jansen 1999)
///
/// Here S is the first-order index, T the total index, f the output minus its mean over A and B, and V the
/// variance over both. Each index is the mean over the replicates of SobolPoints, with the error of that
/// mean. A single uncertain input has S = T = 1. `samples` has the meaning of SampleOrder::samples.
Sensitivity sensitivityOf(const DesignProblem& problem, std::uint64_t design,
                          const std::vector<std::size_t>& outputs, std::uint64_t samples, std::uint64_t seed,
                          const DesignWork& work);

}  // namespace drillwave
