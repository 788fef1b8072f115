// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/problem.h"

#include <utility>

#include "core/model/scales.h"

namespace drillwave {

Problem problemOf(const Scenario& scenario) {
    return problemOf(pulseForceOf(scenario), groupsOf(scenario));
}

Problem problemOf(PulseForce hammer, const Groups& groups) {
    return {std::move(hammer), groups.tau, {groups.beta, groups.gamma}, groups.delta};
}

}  // namespace drillwave
