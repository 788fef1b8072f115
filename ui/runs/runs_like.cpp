// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_like.h"

namespace drillwave {

RunList runsLike(const Scenario& scenario, const RunList& runs) {
    RunList alike;
    for (const Run& run : runs)
        if (isString(run.contents.scenario) == isString(scenario)) alike.push_back(run);
    return alike;
}

}  // namespace drillwave
