// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of a design study to its solver: designs, uncertain inputs and outputs.
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

/// Solver of single blows of a design, for given values of the uncertain inputs. Each thread needs its own
/// object.
class DesignSolver {
  public:
    DesignSolver() = default;
    virtual ~DesignSolver() = default;
    DesignSolver(const DesignSolver&) = delete;
    DesignSolver& operator=(const DesignSolver&) = delete;

    /// Solves a blow of a design and writes its results to `outputs`. `design` is an index from 0; `values`
    /// has one value for each uncertain input. Returns the reason if there are no results; empty otherwise.
    virtual Message solve(std::uint64_t design, std::span<const double> values, std::span<double> outputs,
                          const std::stop_token& stop) = 0;
    /// Solves a blow of a design with all uncertain inputs at the values of the scenario, and writes its
    /// results to `outputs`. `design` is an index from 0. Returns the reason if there are no results; empty
    /// otherwise.
    virtual Message solveNominal(std::uint64_t design, std::span<double> outputs,
                                 const std::stop_token& stop) = 0;
};

/// Interface to the designs of a study with their uncertain inputs and outputs, for sampling and searches.
/// Safe to use from several threads.
class DesignProblem {
  public:
    DesignProblem() = default;
    virtual ~DesignProblem() = default;
    DesignProblem(const DesignProblem&) = delete;
    DesignProblem& operator=(const DesignProblem&) = delete;

    virtual std::uint64_t designCount() const = 0;
    virtual std::size_t outputCount() const = 0;
    /// Returns the distributions of the uncertain inputs of a design: at least one, and the same number for
    /// every design.
    virtual std::vector<Distribution> distributions(std::uint64_t design) const = 0;
    virtual std::unique_ptr<DesignSolver> solver() const = 0;
    /// Returns values of one uncertain input (index `coordinate`), inside its range, near which worst cases
    /// are likely.
    virtual std::vector<double> likelyPlaces(std::uint64_t /*design*/, std::size_t /*coordinate*/) const {
        return {};
    }
};

/// Callback for progress, called with the number of samples solved since the last call.
using SolveProgress = std::function<void(std::uint64_t)>;

/// Execution settings of a design study: number of threads (≥ 1), stop token and progress callback.
struct DesignWork {
    int jobs = 1;
    std::stop_token stop = {};
    SolveProgress progress = {};

    void tell(std::uint64_t solves) const {
        if (progress) progress(solves);
    }
};

}  // namespace drillwave
