// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_margins.h"

#include <utility>

#include "core/blow/feed_estimate.h"

namespace drillwave {

void addThrustMargin(Blow& blow, const std::stop_token& stop) {
    if (!blow.isSolved()) return;
    std::optional<FeedEstimate> ofAllGaps =
        ThrustMargins(mostPiecesInPassing)
            .estimate(blow.scenario, blow.problem, {blow.impact.cor, blow.impact.corError}, stop);
    if (ofAllGaps) blow.feed = std::move(ofAllGaps);
}

std::optional<FeedEstimate> solveFeedEstimate(const Scenario& scenario, const std::stop_token& stop) {
    if (!thrustProblem(scenario).isEmpty()) return std::nullopt;
    Blow blow = solveBlow(scenario, {}, Detail::ledger, stop);
    addThrustMargin(blow, stop);
    return blow.isSolved() ? blow.feed : std::nullopt;
}

std::optional<double> ThrustMargins::of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                                        const std::stop_token& stop) {
    const std::optional<FeedEstimate> feed = estimate(scenario, problem, cor, stop);
    return feed ? feed->margin() : std::nullopt;
}

std::optional<FeedEstimate> ThrustMargins::estimate(const Scenario& scenario, const Problem& problem,
                                                    const Estimate& cor, const std::stop_token& stop) {
    if (!thrustMarginProblem(scenario).isEmpty()) return std::nullopt;
    const std::optional<ReboundsOverGaps> overGaps = m_finder.of(problem, stop).known();
    if (!overGaps) return std::nullopt;
    return feedEstimate(scenario, cor, 1, overGaps);
}

}  // namespace drillwave
