// SPDX-License-Identifier: GPL-3.0-or-later
// Subject of a design study, whatever solves it: designs, uncertain numbers, outputs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/numeric/ordered_work.h"
#include "core/study/design/distribution.h"
#include "core/text/message.h"

namespace drillwave {

/// Solves one point after another. One for each thread.
class DesignSolver {
  public:
    DesignSolver() = default;
    virtual ~DesignSolver() = default;
    DesignSolver(const DesignSolver&) = delete;
    DesignSolver& operator=(const DesignSolver&) = delete;

    /// Puts the outputs of a design (from 0) at uncertain values, one of each distribution, into `outputs`.
    /// Returns why there are none; empty when there are.
    virtual Message solve(std::uint64_t design, std::span<const double> values, std::span<double> outputs,
                          const std::stop_token& stop) = 0;
    /// Solves with the uncertain numbers as the scenario has them.
    virtual Message solveNominal(std::uint64_t design, std::span<double> outputs,
                                 const std::stop_token& stop) = 0;
};

/// Safe for several threads.
class DesignProblem {
  public:
    DesignProblem() = default;
    virtual ~DesignProblem() = default;
    DesignProblem(const DesignProblem&) = delete;
    DesignProblem& operator=(const DesignProblem&) = delete;

    virtual std::uint64_t designCount() const = 0;
    virtual std::size_t outputCount() const = 0;
    /// Returns those of the uncertain numbers: at least one, equally many for each design.
    virtual std::vector<Distribution> distributions(std::uint64_t design) const = 0;
    virtual std::unique_ptr<DesignSolver> solver() const = 0;
    /// Returns places in the box of a coordinate, besides its ends, where worst cases are likely.
    virtual std::vector<double> likelyPlaces(std::uint64_t /*design*/, std::size_t /*coordinate*/) const {
        return {};
    }
};

/// Called with the number of points solved since the last call.
using SolveProgress = std::function<void(std::uint64_t)>;

/// Way of working: threads (≥ 1), stop, progress.
struct DesignWork {
    int jobs = 1;
    std::stop_token stop = {};
    SolveProgress progress = {};

    void tell(std::uint64_t solves) const {
        if (progress) progress(solves);
    }
};

}  // namespace drillwave
