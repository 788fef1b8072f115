// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/nearest_name.h"

namespace drillwave {
namespace {

using Chain = SectionAddress::Chain;

constexpr std::string_view repeatKey = "string.repeat";
constexpr std::size_t maximumNameBytes = 100;
constexpr std::size_t maximumPlaceDigits = 9;

bool isWholeNumber(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// A name whose blanks may be written `_`, which needs no quotes on a command line.
std::string spoken(std::string_view name) {
    std::string text(name);
    std::ranges::replace(text, '_', ' ');
    return text;
}

/// Calls `visit` with every section that the address names, and which of its chain it is in a file, from 0.
template <class String, class Visit>
void visitNumbered(const SectionAddress& address, String& drillString, const Visit& visit) {
    std::size_t first = 0;  // of the list
    const auto visitList = [&](auto& sections, std::uint64_t before, std::uint64_t repeat) {
        const std::uint64_t count = sections.size();
        for (std::uint64_t i = 0; i < count; ++i) {
            const bool inside = address.place > before && address.place - before <= repeat * count;
            const bool here = address.place == 0 ? spoken(sections[i].name) == spoken(address.name)
                                                 : inside && (address.place - before - 1) % count == i;
            if (here) visit(sections[i], first + i);
        }
        first += count;
        return before + repeat * count;
    };
    if (address.chain == Chain::hammer) {
        visitList(drillString.hammer.sections, 0, 1);
        return;
    }
    std::uint64_t before = 0;
    for (auto& part : drillString.parts)
        before = visitList(part.sections, before, static_cast<std::uint64_t>(std::max(part.repeat, 0)));
}

template <class String, class Visit>
void visitSections(const SectionAddress& address, String& drillString, const Visit& visit) {
    visitNumbered(address, drillString, [&](auto& section, std::size_t) { visit(section); });
}

std::vector<std::size_t> numbersOf(const SectionAddress& address, const Scenario& scenario) {
    std::vector<std::size_t> numbers;
    visitNumbered(address, scenario.drillString,
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
        if (address.field->applies(section)) address.field->assign(section, value);
    });
}

void clearAt(const SectionAddress& address, Scenario& scenario) {
    visitSections(address, scenario.drillString, [&](Section& section) { address.field->clear(section); });
}

/// Of the first repeat; 0 for what is no number of times at all.
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
        "How often the sections of the first repeat of the string follow one another",
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

/// "adapter", "section 3", "hammer section 1".
std::string wordsFor(const SectionAddress& address) {
    const std::string_view hammer = address.chain == Chain::hammer ? "hammer " : "";
    return std::string(hammer) +
           (address.place == 0 ? spoken(address.name) : "section " + std::to_string(address.place));
}

/// A parameter with the texts it refers to.
struct OwnedParameter {
    std::string key;
    std::string label;
    SectionAddress address;
    Parameter parameter;

    OwnedParameter(std::string_view itsKey, const SectionAddress& itsAddress)
        : key(itsKey),
          label(std::string(itsAddress.field->label) + " of " + wordsFor(itsAddress)),
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

/// The three pieces of "string.bit skirt.length".
struct KeyPieces {
    std::string_view chain, sections, field;
};
std::optional<KeyPieces> piecesOf(std::string_view key) {
    const std::size_t first = key.find('.'), last = key.rfind('.');
    if (first == last || last == first + 1) return std::nullopt;
    return KeyPieces{key.substr(0, first), key.substr(first + 1, last - first - 1), key.substr(last + 1)};
}

std::optional<SectionAddress> addressOf(std::string_view key) {
    const std::optional<KeyPieces> pieces = piecesOf(key);
    if (!pieces || (pieces->chain != "string" && pieces->chain != "hammer")) return std::nullopt;
    SectionAddress address;
    address.chain = pieces->chain == "hammer" ? Chain::hammer : Chain::string;
    address.field = findSectionField(pieces->field);
    if (!address.field || pieces->sections.size() > maximumNameBytes) return std::nullopt;
    if (!isWholeNumber(pieces->sections)) {
        address.name = pieces->sections;
        return address;
    }
    if (pieces->sections.size() > maximumPlaceDigits || pieces->sections.front() == '0') return std::nullopt;
    std::from_chars(pieces->sections.data(), pieces->sections.data() + pieces->sections.size(),
                    address.place);
    return address;
}

std::vector<std::string_view> namesIn(const SectionAddress& address, const DrillString& drillString) {
    std::vector<std::string_view> names;
    const auto add = [&](const Section& section) {
        if (!section.name.empty() && std::ranges::find(names, section.name) == names.end())
            names.push_back(section.name);
    };
    if (address.chain == Chain::hammer)
        for (const Section& section : drillString.hammer.sections) add(section);
    else
        for (const PlacedSection& placed : placedSections(drillString)) add(*placed.section);
    return names;
}

std::string noSuchName(const SectionAddress& address, const DrillString& drillString) {
    const std::vector<std::string_view> names = namesIn(address, drillString);
    const std::string_view near = nearestName(spoken(address.name), names);
    std::string list;
    for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    const std::string chain = address.chain == Chain::hammer ? "hammer" : "string";
    return "no section of the " + chain + " is called `" + shortened(address.name) + "`; " +
           (!near.empty()  ? "did you mean `" + std::string(near) + "`?"
            : list.empty() ? "its sections have no names, give a place: `" + chain + ".1." +
                                 std::string(address.field->key) + "`"
                           : "its names: " + shortened(list));
}

std::string noSuchPlace(const SectionAddress& address, const DrillString& drillString) {
    const bool hammer = address.chain == Chain::hammer;
    const std::uint64_t count = hammer ? drillString.hammer.sections.size() : sectionCount(drillString);
    return std::string("the ") + (hammer ? "hammer" : "string") + " has only " + std::to_string(count) +
           (count == 1 ? " section" : " sections");
}

}  // namespace

bool SectionAddress::hasSameSections(const SectionAddress& other) const {
    return chain == other.chain && place == other.place && spoken(name) == spoken(other.name);
}

KeptParameter findSectionParameter(std::string_view key) {
    if (key == repeatKey) return repeatParameter();
    const std::optional<SectionAddress> address = addressOf(key);
    if (!address) return nullptr;
    const auto owned = std::make_shared<const OwnedParameter>(key, *address);
    return KeptParameter(std::shared_ptr<const Parameter>(owned, &owned->parameter));
}

std::string sectionKey(Chain chain, std::uint64_t place) {
    return (chain == Chain::hammer ? "hammer." : "string.") + std::to_string(place);
}

std::string sectionKey(Chain chain, std::uint64_t place, std::string_view field) {
    return sectionKey(chain, place) + "." + std::string(field);
}

bool hasSectionFor(const Parameter& parameter, const Scenario& scenario) {
    if (!isString(scenario)) return false;
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

std::string meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                           const Scenario& ofOther) {
    if (!mayMeet(one, other) || !isString(ofOne) || !isString(ofOther)) return {};
    const SectionAddress &a = *one.address, &b = *other.address;
    const std::vector<std::size_t> numbers = numbersOf(a, ofOne);
    const auto isOfOne = [&](std::size_t number) {
        return std::ranges::find(numbers, number) != numbers.end();
    };
    if (std::ranges::none_of(numbersOf(b, ofOther), isOfOne)) return {};
    if (a.place > 0 && b.place > 0) return "set one section, which a repeat brings to both places";
    const SectionAddress& place = a.place > 0 ? a : b;
    return "set one section: section " + std::to_string(place.place) + " of the " +
           (place.chain == Chain::hammer ? "hammer" : "string") + " is called " +
           shortened(a.place > 0 ? b.name : a.name);
}

std::string whyNoSection(const Parameter& parameter, const Scenario& scenario) {
    if (!isString(scenario)) return "only a drill string has it (`drillwave: 2`), this is a uniform rod";
    if (!parameter.address) return "the string has no repeat";
    const SectionAddress& address = *parameter.address;
    bool found = false;
    visitSections(address, scenario.drillString, [&](const Section&) { found = true; });
    if (found && address.field->with == SectionField::With::area)
        return "goes with an area, and the section is given by its diameter";
    if (found) return "goes with a diameter, and the section is given by its area";
    return address.place == 0 ? noSuchName(address, scenario.drillString)
                              : noSuchPlace(address, scenario.drillString);
}

std::string nearestSectionKey(std::string_view key) {
    const std::optional<KeyPieces> pieces = piecesOf(key);
    if (!pieces) return {};
    constexpr std::string_view chains[] = {"string", "hammer"};
    std::vector<std::string_view> fields;
    for (const SectionField& field : sectionFields()) fields.push_back(field.key);
    const std::string_view chain = nearestName(pieces->chain, chains);
    const std::string_view field = nearestName(pieces->field, fields);
    if (chain.empty() || field.empty()) return {};
    const std::string near =
        std::string(chain) + "." + std::string(pieces->sections) + "." + std::string(field);
    return near == key || !addressOf(near) ? std::string() : near;
}

std::vector<KeptParameter> sectionParameters(const Scenario& scenario) {
    std::vector<KeptParameter> parameters;
    if (!isString(scenario)) return parameters;
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
    if (!parameter.address || !isString(scenario)) return {};
    std::string found;
    visitSections(*parameter.address, scenario.drillString,
                  [&](const Section& section) { found = section.name; });
    return found;
}

std::string sectionNameProblem(std::string_view name) {
    if (isWholeNumber(name)) return "must not be a whole number: numbers are the places of sections";
    if (name != trimmed(name)) return "must not begin or end with a blank";
    if (name.size() > maximumNameBytes)
        return "must have at most " + std::to_string(maximumNameBytes) + " bytes";
    return name.empty() ? std::string() : nameProblem(name);
}

}  // namespace drillwave
