// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_like.h"

#include "core/model/blow_traits.h"

namespace drillwave {

RunList runsLike(const Scenario& scenario, const RunList& runs) {
    RunList alike;
    for (const Run& run : runs)
        if (followsFromGroups(run.contents.scenario) == followsFromGroups(scenario)) alike.push_back(run);
    return alike;
}

}  // namespace drillwave
