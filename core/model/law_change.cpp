// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/law_change.h"

#include <utility>

#include "core/model/parameter.h"
#include "core/model/scales.h"

namespace drillwave {

BitRock withLaw(BitRock rock, RockLaw law) {
    Scenario changed;
    changed.bitRock = std::move(rock);
    changed.bitRock.law = law;
    if (law != RockLaw::corners) changed.bitRock.corners.clear();
    const Scenario usual;
    for (const Parameter& parameter : parameters())
        if (parameter.rules.law && *parameter.rules.law != law)
            parameter.assign(changed, *parameter.value(usual));
    return changed.bitRock;
}

BitRock proposedRock(const Scenario& scenario, RockLaw law) {
    constexpr double scaleShare = 0.5;
    BitRock rock = withLaw(scenario.bitRock, law);
    if (law == RockLaw::corners && rock.corners.empty())
        rock.corners.push_back({scaleShare * (hasUnits(scenario) ? scalesOf(scenario).force : 1), 1});
    if (law == RockLaw::power && !hasUnits(scenario)) rock.referencePenetration = scaleShare;
    return rock;
}

}  // namespace drillwave
