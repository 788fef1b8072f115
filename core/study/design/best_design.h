// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the best designs: by the first objective, and as the Pareto set of all objectives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/study/design/design_samples.h"

namespace drillwave {

/// Direction of an objective: whether large or small values are better.
enum class Sense { largest, least };

/// Position of one statistic of one output in DesignSamples::statistics, which is indexed
/// [output][statistic].
struct StatisticPlace {
    std::size_t output = 0;
    std::size_t statistic = 0;
    bool hasError = true;  ///< whether the statistic has a sampling error, as Statistic::hasError() returns
};

/// Objective of a design study in the form that bestOf() uses: a statistic, and whether large or small values
/// are better.
struct AimOrder {
    Sense sense = Sense::largest;
    StatisticPlace place;
};

/// Limit of a design study in the form that bestOf() uses: a statistic, and its upper or lower bound.
struct LimitOrder {
    bool atMost = true;
    StatisticPlace place;
    double bound = 0;
};

/// Result of checking a design against the limits: whether it satisfies them, and whether clearly.
struct Feasibility {
    bool feasible = false;  ///< whether all statistics of the objectives exist and satisfy every limit
    bool marginal = false;  ///< whether a limited statistic is closer to its bound than its own error
};

/// Returns whether a design satisfies all limits. A design without the statistics of the objectives is not
/// feasible.
Feasibility feasibilityOf(const DesignSamples& design, std::span<const AimOrder> aims,
                          std::span<const LimitOrder> limits);

/// Returns whether two designs are equally good in one objective: within the sampling errors, or within
/// rounding if the statistic has no sampling error.
bool areTied(const DesignSamples& one, const DesignSamples& other, const AimOrder& aim);

/// Best designs of a study by several criteria, each given by its index from 0.
struct BestDesigns {
    /// Feasible design whose statistic in the first objective is best; empty if no design is feasible.
    std::optional<std::size_t> robust;
    /// Design that is best if all uncertain inputs have the values of the scenario. The limits then apply to
    /// these values too. Empty if there is none.
    std::optional<std::size_t> nominal;
    /// Feasible designs that are as good as `robust` in the first objective, within the errors; without
    /// `robust` itself.
    std::vector<std::size_t> ties;
    /// Design with the best second objective among `robust` and `ties`. Empty without a second objective or
    /// without ties.
    std::optional<std::size_t> nextBest;
    /// Feasible designs that remain after all objectives, in ascending order. In turn, each objective keeps
    /// only the remaining designs that are best or equally good.
    std::vector<std::size_t> equal;
    /// Recommended design: `robust` (the best in the first objective) if it is in `equal`. Otherwise it is
    /// the design of `equal` that is best in the last objective.
    std::optional<std::size_t> chosen;
    /// For each design, whether it is Pareto-optimal: feasible, and no feasible design is better in one
    /// objective without being worse in another.
    std::vector<bool> pareto;
};

/// Returns the best designs of a study. Requires at least one objective. Among designs that are equal within
/// rounding, the first is taken as best.
BestDesigns bestOf(std::span<const DesignSamples> designs, std::span<const AimOrder> aims,
                   std::span<const LimitOrder> limits);

}  // namespace drillwave
