// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the best designs: by the first objective, and as the Pareto set of all objectives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/study/design/design_samples.h"

namespace drillwave {

/// Direction of an objective (called aim in the code): whether large or small values are better.
enum class Sense { largest, least };

/// Location of one statistic of one output, as indices into DesignSamples::statistics.
struct StatisticPlace {
    std::size_t output = 0;
    std::size_t statistic = 0;
    bool hasError = true;  ///< whether the statistic has a sampling error, as Statistic::hasError() returns
};

/// Objective of a design study, in the form that bestOf() uses: a statistic and the better direction.
struct AimOrder {
    Sense sense = Sense::largest;
    StatisticPlace place;
};

/// Limit of a design study, in the form that bestOf() uses: a statistic and its upper or lower bound.
struct LimitOrder {
    bool atMost = true;
    StatisticPlace place;
    double bound = 0;
};

/// Whether a design satisfies the limits, and how clearly.
struct Feasibility {
    bool feasible = false;  ///< whether all statistics of the objectives exist and satisfy every limit
    bool marginal = false;  ///< whether a limited statistic is closer to its bound than its own error
};

/// Returns whether a design satisfies the limits. A design without statistics of the objectives is not
/// feasible.
Feasibility feasibilityOf(const DesignSamples& design, std::span<const AimOrder> aims,
                          std::span<const LimitOrder> limits);

/// Returns whether two designs are equally good in one objective: within its errors, or within rounding if
/// its statistic has no error.
bool areTied(const DesignSamples& one, const DesignSamples& other, const AimOrder& aim);

/// Best designs of a study, each given by its index, from 0.
struct BestDesigns {
    /// Feasible design with the best first objective over all samples; empty if no design is feasible.
    std::optional<std::size_t> robust;
    /// Best design for the uncertain inputs at their values entered. The limits apply to those values.
    std::optional<std::size_t> nominal;
    /// Feasible designs that are equally good as the best one (`robust`) in the first objective, within the
    /// errors; without `robust` itself.
    std::vector<std::size_t> ties;
    /// Design with the best second objective among those that are best or equally good in the first. Empty
    /// without a second objective or without equally good designs.
    std::optional<std::size_t> nextBest;
    /// Feasible designs that are best, or equally good, in every objective in turn: each objective selects
    /// among the designs left by those before it. Ascending.
    std::vector<std::size_t> equal;
    /// Recommended design: `robust` (the best in the first objective) if it is in `equal`, otherwise the
    /// design of `equal` that is best in the last objective.
    std::optional<std::size_t> chosen;
    /// For each design, whether it is Pareto-optimal: feasible, and no feasible design is better in one
    /// objective without being worse in another.
    std::vector<bool> pareto;
};

/// Returns the best designs of a study. Requires at least one objective. Among designs that are equal within
/// rounding, the first is taken as best. Statistics without an error count as equal only within rounding.
BestDesigns bestOf(std::span<const DesignSamples> designs, std::span<const AimOrder> aims,
                   std::span<const LimitOrder> limits);

}  // namespace drillwave
