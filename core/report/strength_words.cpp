// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/strength_words.h"

#include <algorithm>
#include <string>

#include "core/blow/string_blow.h"
#include "core/model/parameter.h"
#include "core/model/section_words.h"
#include "core/report/parameter_words.h"
#include "core/text/message.h"

namespace drillwave {
namespace {

const char* firstPattern(const StrengthUse& use) {
    if (use.of == StrengthUse::Strength::fatigue)
        return translatable(
            "During the blow, the most heavily loaded section (%1) has a tension of %2, which is %3 of its "
            "fatigue strength of %4.");
    return use.isTension ? translatable(
                               "During the blow, the most heavily loaded section (%1) has a tension of %2, "
                               "which is %3 of its yield strength of %4.")
                         : translatable(
                               "During the blow, the most heavily loaded section (%1) has a compression of "
                               "%2, which is %3 of its yield strength of %4.");
}

/// Returns the fatigue strength of the rods, or of the first section if no section is a rod.
Message wantedStrength(const Scenario& scenario, const ReadingStyle& style) {
    const std::vector<const Section*> sections = expandedSections(scenario.drillString);
    const bool hasRods =
        std::ranges::any_of(sections, [](const Section* section) { return section->name == "rod"; });
    const char* key = sections.empty() ? "rod.fatigue_strength"
                      : hasRods        ? "string.rod.fatigue_strength"
                                       : "string.1.fatigue_strength";
    return fieldMessage(*findParameter(key), style);
}

}  // namespace

Message strengthSentence(const Scenario& scenario, const std::vector<SectionStress>& stresses,
                         const ReadingStyle& style) {
    if (stresses.empty()) return {};
    const std::vector<std::optional<StrengthUse>> uses = strengthUses(scenario, stresses);
    const std::optional<std::size_t> most = mostUsedSection(uses);
    if (!most)
        return {
            translatable(
                "No section has a strength. Enter a strength (%1) to find the section that breaks first."),
            {wantedStrength(scenario, style)}};
    const StrengthUse& use = *uses[*most];
    const auto stress = [&](double si) { return style.quantity(si, Quantity::stress, 4); };
    const std::vector<Message> words = sectionWords(scenario.drillString);
    const Message first{
        firstPattern(use),
        {words.empty() ? Message(translatable("the rod")) : words[*most], stress(use.peak.stress),
         style.number(100 * use.share(), 3) + " %", stress(use.strength)}};
    const std::size_t ofHammer = scenario.drillString.hammer.sections.size();
    const auto without = static_cast<std::uint64_t>(
        std::count(uses.begin() + static_cast<std::ptrdiff_t>(std::min(ofHammer, uses.size())), uses.end(),
                   std::nullopt));
    if (without == 0) return first;
    return {"%1 %2",
            {first, counted(without, translatable("No strength is given for %1 section of the string."),
                            translatable("No strength is given for %1 sections of the string."))}};
}

}  // namespace drillwave
