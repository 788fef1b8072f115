// SPDX-License-Identifier: GPL-3.0-or-later
// Which designs are best: by the first aim, and which none is better than in every aim.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/study/design/design_samples.h"

namespace drillwave {

/// Direction of an aim: large or small values are good.
enum class Sense { largest, least };

/// A statistic of an output: numbers in DesignSamples::statistics.
struct StatisticPlace {
    std::size_t output = 0;
    std::size_t statistic = 0;
    bool hasError = true;  ///< Statistic::hasError()
};

/// An aim as numbers.
struct AimOrder {
    Sense sense = Sense::largest;
    StatisticPlace place;
};

/// A limit as numbers: at most the bound, or at least.
struct LimitOrder {
    bool atMost = true;
    StatisticPlace place;
    double bound = 0;
};

/// Relation of a design to the limits.
struct Feasibility {
    bool feasible = false;  ///< every limit holds for the value
    bool marginal = false;  ///< some value is within its error of its bound
};

/// Returns not feasible without statistics.
Feasibility feasibilityOf(const DesignSamples& design, std::span<const AimOrder> aims,
                          std::span<const LimitOrder> limits);

/// Returns whether two designs are equal in an aim: within the errors, or within rounding if it has none.
bool areTied(const DesignSamples& one, const DesignSamples& other, const AimOrder& aim);

/// Best of all designs, by number from 0.
struct BestDesigns {
    std::optional<std::size_t> robust;   ///< feasible, best statistic of the first aim
    std::optional<std::size_t> nominal;  ///< best with x as in the scenario; limits apply to those values
    /// Feasible, and equal to the robust best within the errors; without the robust best.
    std::vector<std::size_t> ties;
    /// Best in the next aim among the robust best and its ties; nothing if there is no such aim or no
    /// tie.
    std::optional<std::size_t> nextBest;
    /// Feasible, and best or tied with the best in every aim, each aim deciding among those left by the aims
    /// before it; ascending.
    std::vector<std::size_t> equal;
    std::optional<std::size_t> chosen;  ///< of these the robust best, or else the best in the last aim
    std::vector<bool> pareto;  ///< of each design: feasible, and none is better in one aim and worse in none
};

/// Returns the best designs. Requires at least one aim. The first of those that are equal within rounding is
/// best. Statistics without an error tie only in that case.
BestDesigns bestOf(std::span<const DesignSamples> designs, std::span<const AimOrder> aims,
                   std::span<const LimitOrder> limits);

}  // namespace drillwave
