// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_choice.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/model/section_parameter.h"

namespace drillwave {
namespace {

using Chain = SectionAddress::Chain;

/// Limits of which a blow is warned change nothing, and a hammer that loses energy is not solved.
bool isVariable(const SectionField& field, Chain chain) {
    if (field.key == "yield_strength" || field.key == "fatigue_strength") return false;
    return chain == Chain::string || (field.key != "loss" && field.key != "attenuation");
}

/// As on a command line, where a key ends at "=" and words at blanks.
std::string spelled(std::string name) {
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// The parameter of all sections of that name, where there is one and they agree in it.
KeptParameter byName(Chain chain, const Section& section, const SectionField& field,
                     const Scenario& scenario) {
    if (section.name.empty() || section.name.find('=') != std::string::npos) return nullptr;
    KeptParameter found = findParameter((chain == Chain::hammer ? "hammer." : "string.") +
                                        spelled(section.name) + "." + std::string(field.key));
    return found && found->applies(scenario) && found->value(scenario) ? found : nullptr;
}

void addSection(std::vector<KeptParameter>& parameters, Chain chain, const PlacedSection& placed,
                const Scenario& scenario) {
    for (const SectionField& field : sectionFields()) {
        if (!isVariable(field, chain) || !field.value(*placed.section)) continue;
        KeptParameter parameter = byName(chain, *placed.section, field, scenario);
        if (!parameter)
            parameters.push_back(findParameter(sectionKey(chain, placed.place, field.key)));
        else if (std::ranges::find(parameters, parameter) == parameters.end())
            parameters.push_back(std::move(parameter));
    }
}

}  // namespace

std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario) {
    std::vector<KeptParameter> parameters;
    const std::vector<Section>& hammer = scenario.drillString.hammer.sections;
    for (std::size_t i = 0; i < hammer.size(); ++i)
        addSection(parameters, Chain::hammer, {&hammer[i], i + 1}, scenario);
    if (firstRepeat(scenario.drillString)) parameters.push_back(findParameter("string.repeat"));
    for (const PlacedSection& placed : placedSections(scenario.drillString))
        addSection(parameters, Chain::string, placed, scenario);
    return parameters;
}

KeptParameter typicalSize(const Scenario& scenario) {
    const std::vector<PlacedSection> all = placedSections(scenario.drillString);
    if (all.empty()) return nullptr;
    auto found = std::ranges::find(all, "coupling", [](const PlacedSection& p) { return p.section->name; });
    if (const StringPart* repeated = firstRepeat(scenario.drillString); found == all.end() && repeated)
        found = std::ranges::find(all, &repeated->sections.front(), &PlacedSection::section);
    if (found == all.end()) found = all.begin();
    const SectionField& field = *findSectionField(found->section->area ? "area" : "diameter");
    KeptParameter named = byName(Chain::string, *found->section, field, scenario);
    return named ? named : findParameter(sectionKey(Chain::string, found->place, field.key));
}

}  // namespace drillwave
