// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_needs.h"

#include <algorithm>
#include <cassert>

#include "core/blow/thrust.h"
#include "core/model/blow_traits.h"

namespace drillwave {

namespace {

ThrustNeed needOf(const Scenario& scenario, const Estimate& cor, double transferred = 1) {
    const FeedVerdict verdict = *judgeFeed(scenario, cor.value, transferred);
    ThrustNeed need{.cor = cor,
                    .thrust = verdict.fullRate,
                    .thrustUndamped = verdict.returned,
                    .margin = verdict.margin(),
                    .frequencyLimit = {},
                    .feed = verdict.feed,
                    .gapAtBlow = gapAtBlow(scenario, cor.value, transferred)};
    if (const auto force = verdict.effective())
        need.frequencyLimit = *scenario.drill.blowFrequency * std::max(*force, 0.0) / need.thrust;
    return need;
}

}  // namespace

ThrustNeeds thrustNeeds(const Scenario& scenario, const Estimate& cor, const GapRebounds& rebounds) {
    assert(thrustProblem(scenario).isEmpty() && rebounds.quantile.known() && rebounds.worst.known());
    return {needOf(scenario, cor), needOf(scenario, rebounds.quantile.cor), needOf(scenario, {1, 0}),
            needOf(scenario, rebounds.worst.cor)};
}

ThrustNeeds stringThrustNeeds(const Scenario& scenario, const Estimate& cor, double transferred) {
    assert(!gapHasPeriod(scenario) && thrustProblem(scenario).isEmpty());
    ThrustNeed unknown;
    unknown.known = false;
    return {needOf(scenario, cor, transferred), unknown, needOf(scenario, {1, 0}, transferred), unknown};
}

const ThrustNeed& largestOf(const ThrustNeeds& needs) {
    return *std::ranges::max_element(needs, {},
                                     [](const ThrustNeed& need) { return need.known ? need.thrust : -1; });
}

WidestNeed widestOf(const ThrustNeeds& needs) {
    const ThrustNeed& largest = largestOf(needs);
    return {.which = thrustCases[static_cast<std::size_t>(&largest - needs.data())],
            .thrust = largest.thrust,
            .ofAllGaps = std::ranges::all_of(needs, &ThrustNeed::known)};
}

}  // namespace drillwave
