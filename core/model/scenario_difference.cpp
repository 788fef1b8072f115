// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario_difference.h"

#include <algorithm>

namespace drillwave {

std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter) {
    return parameter.applies(scenario) ? parameter.value(scenario) : std::nullopt;
}

std::vector<const Parameter*> differingParameters(std::span<const Scenario* const> scenarios) {
    std::vector<const Parameter*> differing;
    for (const Parameter& parameter : parameters()) {
        const auto gives = [&](const Scenario* each) { return isGiven(parameter, *each); };
        const auto isOther = [&](const Scenario* each) {
            return valueIn(*each, parameter) != valueIn(*scenarios.front(), parameter);
        };
        if (std::ranges::any_of(scenarios, gives) && std::ranges::any_of(scenarios, isOther))
            differing.push_back(&parameter);
    }
    return differing;
}

}  // namespace drillwave
