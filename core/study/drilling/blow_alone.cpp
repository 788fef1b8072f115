// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/blow_alone.h"

#include "core/blow/blow.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"

namespace drillwave {

BlowAlone blowAlone(const Scenario& scenario, bool wantsCor, const std::stop_token& stop) {
    // that of uniform sections is known without a solution
    if (!wantsCor && hasUniformSections(scenario.drillString)) return {.problem = problemOf(scenario)};
    Scenario touching = scenario;
    touching.bitRock.gap = 0;
    const Blow blow = solveBlow(touching, {}, Detail::ledger, stop);
    BlowAlone alone{.problem = blow.problem};
    alone.problem.gap = scenario.bitRock.gap / scalesOf(scenario).penetration;
    if (wantsCor && blow.isSolved() && blow.summary.transferred > 0)
        alone.cor = blow.summary.impulse / blow.summary.transferred - 1;
    return alone;
}

}  // namespace drillwave
