// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/strength_use.h"

#include <cassert>

namespace drillwave {

std::optional<StrengthUse> strengthUse(const SectionStress& stress,
                                       const std::optional<double>& yieldStrength,
                                       const std::optional<double>& fatigueStrength) {
    using enum StrengthUse::Strength;
    std::optional<StrengthUse> most;
    const auto take = [&most](const StrengthUse& use) {
        if (!most || use.share() > most->share()) most = use;
    };
    if (fatigueStrength) take({fatigue, true, stress.tension, *fatigueStrength});
    if (yieldStrength) {
        const bool isTension = stress.tension.stress > stress.compression.stress;
        take({yield, isTension, isTension ? stress.tension : stress.compression, *yieldStrength});
    }
    return most;
}

std::vector<std::optional<StrengthUse>> strengthUses(const Scenario& scenario,
                                                     const std::vector<SectionStress>& stresses) {
    const std::vector<const Section*> sections = allSections(scenario.drillString);
    std::vector<std::optional<StrengthUse>> uses;
    if (sections.empty()) {
        for (const SectionStress& stress : stresses)
            uses.push_back(strengthUse(stress, scenario.rod.yieldStrength, scenario.rod.fatigueStrength));
        return uses;
    }
    assert(stresses.empty() || stresses.size() == sections.size());
    for (std::size_t j = 0; j < stresses.size(); ++j)
        uses.push_back(strengthUse(stresses[j], sections[j]->yieldStrength, sections[j]->fatigueStrength));
    return uses;
}

std::optional<std::size_t> mostUsedSection(const std::vector<std::optional<StrengthUse>>& uses) {
    std::optional<std::size_t> most;
    for (std::size_t j = 0; j < uses.size(); ++j)
        if (uses[j] && (!most || uses[j]->share() > uses[*most]->share())) most = j;
    return most;
}

}  // namespace drillwave
