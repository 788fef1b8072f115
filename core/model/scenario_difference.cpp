// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario_difference.h"

#include <algorithm>

#include "core/model/section_parameter.h"

namespace drillwave {

std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter) {
    return parameter.applies(scenario) ? parameter.value(scenario) : std::nullopt;
}

std::vector<const Parameter*> differingParameters(std::span<const Scenario* const> scenarios) {
    std::vector<const Parameter*> differing;
    const auto look = [&](const Parameter& parameter) {
        const auto gives = [&](const Scenario* each) { return isGiven(parameter, *each); };
        const auto isOther = [&](const Scenario* each) {
            return valueIn(*each, parameter) != valueIn(*scenarios.front(), parameter);
        };
        if (std::ranges::any_of(scenarios, gives) && std::ranges::any_of(scenarios, isOther))
            differing.push_back(&parameter);
    };
    for (const Parameter& parameter : parameters()) look(parameter);
    std::vector<const Parameter*> ofSections;
    for (const Scenario* scenario : scenarios)
        for (const Parameter* parameter : sectionParameters(*scenario))
            if (std::ranges::find(ofSections, parameter) == ofSections.end()) ofSections.push_back(parameter);
    for (const Parameter* parameter : ofSections) look(*parameter);
    return differing;
}

}  // namespace drillwave
