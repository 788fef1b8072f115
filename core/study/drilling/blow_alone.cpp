// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/blow_alone.h"

#include <limits>

#include "core/blow/blow.h"

namespace drillwave {

double corAtZeroGap(const Scenario& scenario, const std::stop_token& stop) {
    Scenario touching = scenario;
    touching.bitRock.gap = 0;
    const Blow blow = solveBlow(touching, {}, Detail::ledger, stop);
    if (!blow.isSolved() || blow.summary.transferred <= 0) return std::numeric_limits<double>::quiet_NaN();
    return blow.summary.impulse / blow.summary.transferred - 1;
}

}  // namespace drillwave
