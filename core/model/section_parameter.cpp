// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_parameter.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "core/model/blow_traits.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

using Chain = SectionAddress::Chain;

constexpr std::string_view repeatKey = "string.repeat";

std::vector<std::size_t> numbersOf(const SectionAddress& address, const Scenario& scenario) {
    std::vector<std::size_t> numbers;
    visitNumberedSections(address, scenario.drillString,
                          [&](const Section&, std::size_t number) { numbers.push_back(number); });
    return numbers;
}

std::optional<double> valueAt(const SectionAddress& address, const Scenario& scenario) {
    std::optional<double> common;
    bool differs = false, first = true;
    visitSections(address, scenario.drillString, [&](const Section& section) {
        if (!address.field->applies(section)) return;
        const std::optional<double> value = address.field->value(section);
        if (first) common = value;
        differs |= value != common;
        first = false;
    });
    return differs ? std::nullopt : common;
}

void assignAt(const SectionAddress& address, Scenario& scenario, double value) {
    visitSections(address, scenario.drillString, [&](Section& section) {
        if (!address.field->applies(section)) return;
        if (address.field->value(section) != value) section.preset.clear();
        address.field->assign(section, value);
    });
}

void clearAt(const SectionAddress& address, Scenario& scenario) {
    visitSections(address, scenario.drillString, [&](Section& section) {
        if (address.field->value(section)) section.preset.clear();
        address.field->clear(section);
    });
}

/// Sets the count of the first repeat; to 0 for a value that is no count.
void assignRepeat(Scenario& scenario, double value) {
    constexpr double most = std::numeric_limits<int>::max();
    std::vector<StringPart>& parts = scenario.drillString.parts;
    const auto found = std::ranges::find(parts, true, &StringPart::group);
    if (found != parts.end()) found->repeat = value >= 0 ? static_cast<int>(std::min(value, most)) : 0;
}

std::optional<double> repeatOf(const Scenario& scenario) {
    const StringPart* part = firstRepeat(scenario.drillString);
    return part ? std::optional<double>(part->repeat) : std::nullopt;
}

const Parameter& repeatParameter() {
    static const Parameter parameter{
        repeatKey,
        "repeats",
        "",
        "Number of times the sections of the first repeat follow one another",
        Quantity::ratio,
        "",
        {1, static_cast<double>(maximumSections)},
        {1, 30},
        SliderScale::linear,
        Scope::section,
        repeatOf,
        assignRepeat,
        {.wholeNumber = true},
    };
    return parameter;
}

/// A parameter with the texts it refers to.
struct OwnedParameter {
    std::string key;
    std::string label;
    SectionAddress address;
    Parameter parameter;

    OwnedParameter(std::string_view itsKey, const SectionAddress& itsAddress)
        : key(itsKey),
          label(std::string(itsAddress.field->label) + " of " + itsAddress.words()),
          address(itsAddress),
          parameter{key,
                    label,
                    {},  // behind "length of the adapter" a symbol would name anything
                    address.field->meaning,
                    address.field->quantity,
                    address.field->unit,
                    address.field->hard,
                    address.field->plausible,
                    address.field->slider,
                    Scope::section,
                    {valueAt, address},
                    {assignAt, address},
                    {.presence = address.field->presence, .shortLabel = address.field->label},
                    &address} {
        if (address.field->clear) parameter.rules.clear = {clearAt, address};
    }
    OwnedParameter(const OwnedParameter&) = delete;
    OwnedParameter& operator=(const OwnedParameter&) = delete;
};

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

KeptParameter findSectionParameter(std::string_view key) {
    if (key == repeatKey) return repeatParameter();
    const std::optional<SectionAddress> address = findSectionAddress(key);
    if (!address) return nullptr;
    const auto owned = std::make_shared<const OwnedParameter>(key, *address);
    return KeptParameter(std::shared_ptr<const Parameter>(owned, &owned->parameter));
}

bool hasSectionFor(const Parameter& parameter, const Scenario& scenario) {
    if (!parameter.address) return firstRepeat(scenario.drillString) != nullptr;
    bool found = false;
    visitSections(*parameter.address, scenario.drillString,
                  [&](const Section& section) { found |= parameter.address->field->applies(section); });
    return found;
}

bool mayMeet(const Parameter& one, const Parameter& other) {
    if (!one.address || !other.address || one.address->chain != other.address->chain) return false;
    return !one.address->hasSameSections(*other.address) &&
           areRivals(*one.address->field, *other.address->field);
}

Message meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                       const Scenario& ofOther) {
    if (!mayMeet(one, other)) return {};
    const SectionAddress &a = *one.address, &b = *other.address;
    const std::vector<std::size_t> numbers = numbersOf(a, ofOne);
    const auto isOfOne = [&](std::size_t number) {
        return std::ranges::find(numbers, number) != numbers.end();
    };
    if (std::ranges::none_of(numbersOf(b, ofOther), isOfOne)) return {};
    if (a.place > 0 && b.place > 0) return translatable("are the same section of a repeat");
    const SectionAddress& place = a.place > 0 ? a : b;
    return {place.chain == Chain::hammer
                ? translatable("set one section: section %1 of the hammer is called %2")
                : translatable("set one section: section %1 of the string is called %2"),
            {std::to_string(place.place), shortened(a.place > 0 ? b.name : a.name)}};
}

Message whyNoSection(const Parameter& parameter, const Scenario& scenario) {
    if (!hasSections(scenario))
        return translatable("only for drill strings (`drillwave: 2`); this is a uniform rod");
    if (!parameter.address) return translatable("the string has no repeat");
    const SectionAddress& address = *parameter.address;
    bool found = false;
    visitSections(address, scenario.drillString, [&](const Section&) { found = true; });
    if (found && address.field->with == SectionField::With::area)
        return translatable("goes with an area, and the section is given by its diameter");
    if (found) return translatable("goes with a diameter, and the section is given by its area");
    return whyNoneThere(address, scenario.drillString);
}

std::vector<KeptParameter> sectionParameters(const Scenario& scenario) {
    std::vector<KeptParameter> parameters;
    const auto add = [&](Chain chain, std::uint64_t place, const Section& section) {
        for (const SectionField& field : sectionFields())
            if (field.value(section))
                parameters.push_back(findSectionParameter(sectionKey(chain, place, field.key)));
    };
    const std::vector<Section>& hammer = scenario.drillString.hammer.sections;
    for (std::size_t i = 0; i < hammer.size(); ++i) add(Chain::hammer, i + 1, hammer[i]);
    if (firstRepeat(scenario.drillString)) parameters.emplace_back(repeatParameter());
    for (const PlacedSection& placed : placedSections(scenario.drillString))
        add(Chain::string, placed.place, *placed.section);
    return parameters;
}

std::string sectionName(const Parameter& parameter, const Scenario& scenario) {
    if (!parameter.address) return {};
    std::string found;
    visitSections(*parameter.address, scenario.drillString,
                  [&](const Section& section) { found = section.name; });
    return found;
}

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
