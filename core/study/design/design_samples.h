// SPDX-License-Identifier: GPL-3.0-or-later
// Solves every design at the same sample points and collects the statistics of its outputs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/statistic.h"
#include "core/text/message.h"

namespace drillwave {

/// Maximum share of samples that may remain without a solution. A design with more unsolved samples has no
/// statistics.
inline constexpr double mostUnsolvedShare = 1e-3;

/// Number of samples that a thread solves before it takes new ones: large enough for low overhead, small
/// enough to stop soon.
inline constexpr std::uint64_t pointsOfBlock = 256;

/// Results of one design. They are its outputs with all uncertain inputs at the values of the scenario, and
/// statistics over samples of these inputs.
struct DesignSamples {
    /// Outputs of the design with all uncertain inputs at the values of the scenario; NaN if that blow could
    /// not be solved.
    std::vector<double> nominal = {};
    /// Statistics over all samples, indexed [output][statistic] as in SampleOrder::statistics; NaN if too
    /// many samples were not solved.
    std::vector<std::vector<SampledValue>> statistics = {};
    std::uint64_t unsolved = 0;  ///< number of samples without a solution, which the statistics leave out
    Message reason = {};  ///< reason why the first unsolved sample has no solution; empty if all have one
    /// Share of samples, 0 … 1, whose own numerical error exceeds the sampling error of a statistic (see
    /// UncertainPoints).
    double uncertainShare = 0;

    bool hasStatistics(std::uint64_t samples) const {
        return static_cast<double>(unsolved) <= mostUnsolvedShare * static_cast<double>(samples);
    }
};

/// Settings for counting samples whose own numerical error is larger than the sampling error of a mean or
/// quantile.
struct UncertainPoints {
    std::size_t errorOutput;  ///< index of the output that holds the numerical error of a sample
    /// For each output, whether the numerical error of a sample is relative to the output's value; otherwise
    /// it is absolute.
    std::vector<bool> isRelative;
    bool concerns(std::size_t output) const { return output != errorOutput; }
};

/// Order to sample the designs: number and random seed of the samples, and the statistics to compute from
/// them.
struct SampleOrder {
    std::uint64_t samples = 4096;  ///< number of samples N for each design: a power of two, at least 64
    std::uint64_t seed = 1;
    /// Statistics to compute for each output of the design problem; the list of an output may be empty.
    std::vector<std::vector<Statistic>> statistics;
    std::optional<UncertainPoints> uncertain = {};
};

/// Returns the results of all designs, in their order. All designs are solved at the same sample points (see
/// SobolPoints). The results of a design do not depend on the number of threads or on other designs. Only the
/// samples of one design at a time are in memory. After a stop request, only finished designs are returned.
std::vector<DesignSamples> sampleDesigns(const DesignProblem& problem, const SampleOrder& order,
                                         const DesignWork& work);

}  // namespace drillwave
