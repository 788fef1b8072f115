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

/// Maximum share of samples without a solution. A design with more has no statistics.
inline constexpr double mostUnsolvedShare = 1e-3;

/// Number of samples that a thread takes at a time: large enough for low overhead, small enough to end soon.
inline constexpr std::uint64_t pointsOfBlock = 256;

/// Results of one design: outputs at the values entered, and statistics over all samples.
struct DesignSamples {
    /// Outputs for the uncertain inputs at their values entered; NaN if that blow was not solved.
    std::vector<double> nominal = {};
    /// Statistics of the samples, indexed [output][statistic] in the requested order; NaN without enough
    /// samples.
    std::vector<std::vector<SampledValue>> statistics = {};
    std::uint64_t unsolved = 0;  ///< number of samples without a solution, which the statistics leave out
    Message reason = {};  ///< reason why the first unsolved sample has no solution; empty if all have one
    /// Share of samples, 0 … 1, whose own numerical error exceeds the error of a statistic (see
    /// UncertainPoints).
    double uncertainShare = 0;

    bool hasStatistics(std::uint64_t samples) const {
        return static_cast<double>(unsolved) <= mostUnsolvedShare * static_cast<double>(samples);
    }
};

/// Settings for counting samples whose own numerical error exceeds the sampling error of a mean or quantile.
struct UncertainPoints {
    std::size_t errorOutput;  ///< index of the output that holds the numerical error of a sample
    /// For each output, whether the error of a sample is relative to its value; otherwise it is absolute.
    std::vector<bool> isRelative;
    bool concerns(std::size_t output) const { return output != errorOutput; }
};

/// Number and random seed of the samples, and the statistics to compute from them.
struct SampleOrder {
    std::uint64_t samples = 4096;  ///< number of samples N for each design: a power of two, at least 64
    std::uint64_t seed = 1;
    /// Statistics to compute for each output; the list of an output may be empty.
    std::vector<std::vector<Statistic>> statistics;
    std::optional<UncertainPoints> uncertain = {};
};

/// Returns the results of all designs, in their order. All designs are solved at the same sample points (see
/// SobolPoints). Results do not depend on the number of threads or on the other designs. Memory holds the
/// samples of one design at a time. After a stop request, only finished designs are returned.
std::vector<DesignSamples> sampleDesigns(const DesignProblem& problem, const SampleOrder& order,
                                         const DesignWork& work);

}  // namespace drillwave
