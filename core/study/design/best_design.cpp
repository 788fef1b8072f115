// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/best_design.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace drillwave {

namespace {

/// Values that differ by less are equal but for rounding.
constexpr double equalTo = 1e-12;
bool exceeds(double a, double b) {
    return a > b + equalTo * std::max(std::abs(a), std::abs(b));
}

const SampledValue& at(const DesignSamples& design, const StatisticPlace& place) {
    return design.statistics[place.output][place.statistic];
}

bool holds(const LimitOrder& limit, double value) {
    return limit.atMost ? value <= limit.bound : value >= limit.bound;
}

/// Larger is better.
double gain(Sense sense, double value) {
    return sense == Sense::largest ? value : -value;
}

double aimed(const DesignSamples& design, const AimOrder& aim) {
    return gain(aim.sense, at(design, aim.place).value);
}

bool dominates(const DesignSamples& one, const DesignSamples& other, std::span<const AimOrder> aims) {
    bool better = false;
    for (const AimOrder& aim : aims) {
        const double a = aimed(one, aim), b = aimed(other, aim);
        if (exceeds(b, a)) return false;
        better |= exceeds(a, b);
    }
    return better;
}

bool meetsNominally(const DesignSamples& design, std::span<const LimitOrder> limits) {
    return std::ranges::all_of(
        limits, [&](const LimitOrder& limit) { return holds(limit, design.nominal[limit.place.output]); });
}

/// The candidates that are best in an aim or tied with the best.
std::vector<std::size_t> bestIn(const AimOrder& aim, std::span<const DesignSamples> designs,
                                std::span<const std::size_t> candidates) {
    const std::size_t best = *std::ranges::max_element(
        candidates, {}, [&](std::size_t design) { return aimed(designs[design], aim); });
    std::vector<std::size_t> left;
    std::ranges::copy_if(candidates, std::back_inserter(left), [&](std::size_t design) {
        return design == best || areTied(designs[design], designs[best], aim);
    });
    return left;
}

/// Follows the aims in their order.
void followAims(std::span<const DesignSamples> designs, std::span<const AimOrder> aims,
                std::vector<std::size_t> feasible, BestDesigns& best) {
    if (feasible.empty()) return;
    for (const AimOrder& aim : aims) feasible = bestIn(aim, designs, feasible);
    best.equal = std::move(feasible);
    best.chosen = std::ranges::find(best.equal, *best.robust) != best.equal.end()
                      ? *best.robust
                      : *std::ranges::max_element(best.equal, {}, [&](std::size_t design) {
                            return aimed(designs[design], aims.back());
                        });
}

}  // namespace

bool areTied(const DesignSamples& one, const DesignSamples& other, const AimOrder& aim) {
    const SampledValue &a = at(one, aim.place), &b = at(other, aim.place);
    const bool areEqual = !exceeds(a.value, b.value) && !exceeds(b.value, a.value);
    return areEqual || (aim.place.hasError && areEqualWithinErrors(a, b));
}

Feasibility feasibilityOf(const DesignSamples& design, std::span<const AimOrder> aims,
                          std::span<const LimitOrder> limits) {
    Feasibility found{.feasible = true};
    for (const AimOrder& aim : aims) found.feasible &= !std::isnan(at(design, aim.place).value);
    for (const LimitOrder& limit : limits) {
        const SampledValue& value = at(design, limit.place);
        found.feasible &= holds(limit, value.value);
        found.marginal |= limit.place.hasError && std::abs(value.value - limit.bound) < value.error();
    }
    return found;
}

BestDesigns bestOf(std::span<const DesignSamples> designs, std::span<const AimOrder> aims,
                   std::span<const LimitOrder> limits) {
    assert(!aims.empty());
    const AimOrder& first = aims.front();
    BestDesigns best;
    std::vector<std::size_t> feasible;
    for (std::size_t d = 0; d < designs.size(); ++d) {
        const double nominal = gain(first.sense, designs[d].nominal[first.place.output]);
        if (!std::isnan(nominal) && meetsNominally(designs[d], limits) &&
            (!best.nominal ||
             exceeds(nominal, gain(first.sense, designs[*best.nominal].nominal[first.place.output]))))
            best.nominal = d;
        if (!feasibilityOf(designs[d], aims, limits).feasible) continue;
        feasible.push_back(d);
        if (!best.robust || exceeds(aimed(designs[d], first), aimed(designs[*best.robust], first)))
            best.robust = d;
    }
    best.pareto.assign(designs.size(), false);
    for (const std::size_t d : feasible) {
        if (d != *best.robust && areTied(designs[d], designs[*best.robust], first)) best.ties.push_back(d);
        best.pareto[d] = std::ranges::none_of(
            feasible, [&](std::size_t other) { return dominates(designs[other], designs[d], aims); });
    }
    followAims(designs, aims, feasible, best);
    if (aims.size() < 2 || best.ties.empty()) return best;
    best.nextBest = best.robust;
    for (const std::size_t tie : best.ties)
        if (exceeds(aimed(designs[tie], aims[1]), aimed(designs[*best.nextBest], aims[1])))
            best.nextBest = tie;
    return best;
}

}  // namespace drillwave
