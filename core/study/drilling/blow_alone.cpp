// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/blow_alone.h"

#include <algorithm>

#include "core/blow/blow.h"

namespace drillwave {

std::optional<BlowAlone> solveBlowAlone(const Scenario& scenario, const std::stop_token& stop) {
    Scenario touching = scenario;
    touching.bitRock.gap = 0;
    const Blow blow = solveBlow(touching, {}, Detail::ledger, stop);
    if (!blow.isSolved() || blow.summary.transferred <= 0) return std::nullopt;
    const double penetration = blow.summary.residualPenetration * blow.scales.penetration;
    // The work on the rock, and with it the penetration that stays, is as exact as e and the efficiency.
    const double share = std::max(blow.summary.corError, blow.summary.efficiencyError);
    return BlowAlone{.cor = blow.summary.impulse / blow.summary.transferred - 1,
                     .penetration = {penetration, penetration * share}};
}

}  // namespace drillwave
