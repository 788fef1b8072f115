// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_address.h"

#include <charconv>
#include <vector>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {
namespace {

using Chain = SectionAddress::Chain;

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

/// The three pieces of "string.bit skirt.length".
struct KeyPieces {
    std::string_view chain, sections, field;
};
std::optional<KeyPieces> piecesOf(std::string_view key) {
    const std::size_t first = key.find('.'), last = key.rfind('.');
    if (first == last || last == first + 1) return std::nullopt;
    return KeyPieces{key.substr(0, first), key.substr(first + 1, last - first - 1), key.substr(last + 1)};
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

Message noSuchName(const SectionAddress& address, const DrillString& drillString) {
    const std::vector<std::string_view> names = namesIn(address, drillString);
    const std::string_view near = nearestName(spoken(address.name), names);
    std::string list;
    for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    const bool hammer = address.chain == Chain::hammer;
    const std::string name = shortened(address.name);
    if (!near.empty())
        return {hammer ? translatable("no section of the hammer is called `%1`; did you mean `%2`?")
                       : translatable("no section of the string is called `%1`; did you mean `%2`?"),
                {name, std::string(near)}};
    if (!list.empty())
        return {hammer ? translatable("no section of the hammer is called `%1`; its names: %2")
                       : translatable("no section of the string is called `%1`; its names: %2"),
                {name, shortened(list)}};
    return {
        hammer
            ? translatable(
                  "no section of the hammer is called `%1`; its sections have no names, give a place: `%2`")
            : translatable(
                  "no section of the string is called `%1`; its sections have no names, give a place: `%2`"),
        {name, sectionKey(address.chain, 1, address.field->key)}};
}

Message noSuchPlace(const SectionAddress& address, const DrillString& drillString) {
    const bool hammer = address.chain == Chain::hammer;
    const std::uint64_t count = hammer ? drillString.hammer.sections.size() : sectionCount(drillString);
    const char* pattern = hammer ? (count == 1 ? translatable("the hammer has only %1 section")
                                               : translatable("the hammer has only %1 sections"))
                                 : (count == 1 ? translatable("the string has only %1 section")
                                               : translatable("the string has only %1 sections"));
    return {pattern, {std::to_string(count)}};
}

}  // namespace

bool SectionAddress::isCalled(std::string_view section) const {
    const auto blank = [](char c) { return c == '_' ? ' ' : c; };
    return std::ranges::equal(section, name, {}, blank, blank);
}

std::string SectionAddress::words() const {
    const std::string_view hammer = chain == Chain::hammer ? "hammer " : "";
    return std::string(hammer) + (place == 0 ? spoken(name) : "section " + std::to_string(place));
}

bool SectionAddress::hasSameSections(const SectionAddress& other) const {
    return chain == other.chain && place == other.place && isCalled(other.name);
}

std::optional<SectionAddress> findSectionAddress(std::string_view key) {
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

std::string sectionKey(Chain chain, std::uint64_t place) {
    return (chain == Chain::hammer ? "hammer." : "string.") + std::to_string(place);
}

std::string sectionKey(Chain chain, std::uint64_t place, std::string_view field) {
    return sectionKey(chain, place) + "." + std::string(field);
}

Message whyNoneThere(const SectionAddress& address, const DrillString& drillString) {
    return address.place == 0 ? noSuchName(address, drillString) : noSuchPlace(address, drillString);
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
    return near == key || !findSectionAddress(near) ? std::string() : near;
}

Message sectionNameProblem(std::string_view name) {
    if (isWholeNumber(name))
        return translatable("must not be a whole number: numbers are the places of sections");
    if (name != trimmed(name)) return translatable("must not begin or end with a blank");
    if (name.size() > maximumNameBytes)
        return {translatable("must have at most %1 bytes"), {std::to_string(maximumNameBytes)}};
    return name.empty() ? Message() : nameProblem(name);
}

}  // namespace drillwave
