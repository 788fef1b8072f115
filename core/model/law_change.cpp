// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/law_change.h"

#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"

namespace drillwave {

BitRock withLaw(BitRock rock, RockLaw law) {
    if (law != RockLaw::corners) rock.corners.clear();
    Scenario changed;
    changed.bitRock = std::move(rock);
    for (const Parameter& parameter : parameters()) {
        if (!parameter.rules.law || *parameter.rules.law == law) continue;
        Scenario usual;
        usual.bitRock.law = changed.bitRock.law = *parameter.rules.law;  // so that the number has a meaning
        parameter.assign(changed, *parameter.value(usual));
    }
    changed.bitRock.law = law;
    return changed.bitRock;
}

BitRock proposedRock(const Scenario& scenario, RockLaw law) {
    constexpr double scaleShare = 0.5;
    Scenario proposed = scenario;
    proposed.bitRock = withLaw(scenario.bitRock, law);
    if (law == RockLaw::corners && proposed.bitRock.corners.empty())
        proposed.bitRock.corners.push_back(
            {scaleShare * (hasUnits(scenario) ? scalesOf(scenario).force : 1), 1});
    for (const KeptParameter& number : numbersInScales(proposed)) number->assign(proposed, scaleShare);
    return proposed.bitRock;
}

}  // namespace drillwave
