// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario_difference.h"

#include <algorithm>

#include "core/model/law_parameter.h"
#include "core/model/section_parameter.h"

namespace drillwave {

std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter) {
    return parameter.applies(scenario) ? parameter.value(scenario) : std::nullopt;
}

std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios) {
    std::vector<KeptParameter> differing;
    const auto look = [&](const KeptParameter& kept) {
        const Parameter& parameter = *kept;
        const auto gives = [&](const Scenario* each) { return isGiven(parameter, *each); };
        const auto isOther = [&](const Scenario* each) {
            return valueIn(*each, parameter) != valueIn(*scenarios.front(), parameter);
        };
        if (std::ranges::any_of(scenarios, gives) && std::ranges::any_of(scenarios, isOther))
            differing.push_back(kept);
    };
    for (const Parameter& parameter : parameters()) look(parameter);
    const auto isListed = [&](const KeptParameter& parameter) {
        return std::ranges::any_of(differing,
                                   [&](const KeptParameter& other) { return other->key == parameter->key; });
    };
    for (const auto& numbersOf : {loadingNumbers, sectionParameters})
        for (const Scenario* scenario : scenarios)
            for (const KeptParameter& parameter : numbersOf(*scenario))
                if (!isListed(parameter)) look(parameter);
    return differing;
}

}  // namespace drillwave
