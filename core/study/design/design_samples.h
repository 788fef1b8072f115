// SPDX-License-Identifier: GPL-3.0-or-later
// Every design solved at the same points, and the statistics of its outputs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/statistic.h"
#include "core/text/message.h"

namespace drillwave {

/// Beyond this share of points that could not be solved a design has no statistics.
inline constexpr double mostUnsolvedShare = 1e-3;

/// Number of points in one piece of work: enough to make handing over cheap, few enough to end soon.
inline constexpr std::uint64_t pointsOfBlock = 256;

/// Results of a design.
struct DesignSamples {
    std::vector<double> nominal = {};  ///< outputs; NaN where that blow could not be solved
    /// Output by output, in the order of the requested statistics; NaN where there are none.
    std::vector<std::vector<SampledValue>> statistics = {};
    std::uint64_t unsolved = 0;  ///< points left out
    Message reason = {};         ///< of the first one
    double uncertainShare = 0;   ///< of points, see UncertainPoints

    bool hasStatistics(std::uint64_t samples) const {
        return static_cast<double>(unsolved) <= mostUnsolvedShare * static_cast<double>(samples);
    }
};

/// Search for points that are less certain than the statistics: those whose own error is larger than that of
/// mean or quantile.
struct UncertainPoints {
    std::size_t errorOutput;       ///< output whose value is the own error of a point
    std::vector<bool> isRelative;  ///< of each output: the error is one of the value, not of 1
    bool concerns(std::size_t output) const { return output != errorOutput; }
};

/// Number of points, which ones, and their statistics.
struct SampleOrder {
    std::uint64_t samples = 4096;  ///< N, a power of two, at least 64
    std::uint64_t seed = 1;
    std::vector<std::vector<Statistic>> statistics;  ///< of each output; some may have none
    std::optional<UncertainPoints> uncertain = {};
};

/// Solves all designs, each at the same points of SobolPoints, in order. Results depend neither on the number
/// of threads nor on the other designs. Keeps the outputs of one design at a time; after a stop, returns
/// those that are finished.
std::vector<DesignSamples> sampleDesigns(const DesignProblem& problem, const SampleOrder& order,
                                         const DesignWork& work);

}  // namespace drillwave
