// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario_difference.h"

#include <algorithm>
#include <set>
#include <string_view>

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
    std::size_t corners = 0;
    for (const Scenario* scenario : scenarios) corners = std::max(corners, scenario->bitRock.corners.size());
    for (std::size_t place = 1; place <= corners; ++place)
        for (const std::string_view field : {"force", "slope"})
            look(inFormOf(*scenarios.front(), *findParameter(cornerKey(place, field))));
    std::vector<KeptParameter> ofSections;
    std::set<std::string_view> keys;
    for (const Scenario* scenario : scenarios)
        for (const KeptParameter& parameter : sectionParameters(*scenario))
            if (keys.insert(parameter->key).second) ofSections.push_back(parameter);
    for (const KeptParameter& parameter : ofSections) look(parameter);
    return differing;
}

}  // namespace drillwave
