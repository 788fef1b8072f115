// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_margins.h"

#include "core/blow/thrust.h"

namespace drillwave {

void addThrustMargin(Blow& blow, const std::stop_token& stop) {
    if (!blow.isSolved()) return;
    blow.widestNeed = ThrustMargins(mostPiecesInPassing)
                          .widest(blow.scenario, blow.problem, {blow.impact.cor, blow.impact.corError}, stop);
}

std::optional<double> ThrustMargins::of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                                        const std::stop_token& stop) {
    const std::optional<WidestNeed> need = widest(scenario, problem, cor, stop);
    if (!need) return std::nullopt;
    return feedForceOf(scenario)->marginOver(need->thrust);
}

std::optional<WidestNeed> ThrustMargins::widest(const Scenario& scenario, const Problem& problem,
                                                const Estimate& cor, const std::stop_token& stop) {
    if (!thrustMarginProblem(scenario).isEmpty()) return std::nullopt;
    const GapRebounds rebounds = m_finder.of(problem, stop);
    if (!rebounds.quantile.known() || !rebounds.worst.known()) return std::nullopt;
    return widestOf(thrustNeeds(scenario, cor, rebounds));
}

}  // namespace drillwave
