// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/outputs_changes.h"

#include <algorithm>
#include <vector>

#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/model/section_pieces.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// The first version with outputs of version 2.
constexpr std::string_view versionOfOutputs2 = "0.3.0";

bool hasLosses(const Scenario& scenario) {
    return std::ranges::any_of(allSections(scenario.drillString), [](const Section* section) {
        return section->loss > 0 || section->attenuation > 0;
    });
}

/// Names the numbers that are others now, in the middle of a sentence.
Message changedNumbers(std::string_view version, const Scenario& scenario) {
    if (!isNewerVersion(versionOfOutputs2, version)) return {};
    std::vector<Message> changed;
    if (hasSections(scenario)) {
        changed.emplace_back(translatable("sequences of blows"));
        if (!hasUniformSections(scenario.drillString))
            changed.emplace_back(translatable("all results, by its cones"));
        if (hasLosses(scenario))
            changed.emplace_back(translatable("cor and the required feed, by its losses"));
    }
    changed.emplace_back(translatable("contact shares"));
    changed.emplace_back(translatable("statements about the feed"));
    changed.emplace_back(translatable("energies, which are in J beside SI"));
    Message list;
    for (Message& each : changed) list = joined(std::move(list), "%1; %2", std::move(each));
    return list;
}

}  // namespace

Message changesSentence(std::string_view version, const Scenario& scenario) {
    Message changed = changedNumbers(version, scenario);
    if (changed.isEmpty()) return {};
    return {
        translatable("Written by Drillwave %1. These results have changed since: %2 (manual, Upgrading)."),
        {shortened(std::string(version)), std::move(changed)}};
}

}  // namespace drillwave
