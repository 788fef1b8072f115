// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/model/string_ranges.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

using Value = std::optional<double>;
using With = SectionField::With;
using enum SliderScale;
namespace ranges = string_ranges;

Value diameter(const Section& s) {
    return s.area ? std::nullopt : Value(s.diameter);
}
void assignDiameter(Section& s, double value) {
    s.area.reset();
    s.endArea.reset();
    s.diameter = value;
}

// clang-format off
constexpr std::array fieldTable{
    SectionField{"length", "length", "L", "Length of the section",
                 Quantity::length, "mm", ranges::length, {0.01, 10}, logarithmic, Presence::required,
                 [](const Section& s) { return Value(s.length); }, [](Section& s, double v) { s.length = v; }},
    SectionField{"diameter", "diameter", "", "Outer diameter of the section",
                 Quantity::length, "mm", ranges::diameter, {0.015, 0.25}, linear, Presence::either, diameter, assignDiameter},
    SectionField{"area", "area", "A", "Cross-section, instead of diameter and bore",
                 Quantity::area, "mm^2", ranges::area, {1e-4, 5e-2}, logarithmic, Presence::optional,
                 [](const Section& s) { return s.area; }, [](Section& s, double v) { s.area = v; },
                 [](Section& s) { s.area.reset(); s.endArea.reset(); }},
    SectionField{"bore", "bore", "", "Diameter of the flushing hole, less than the outer diameter",
                 Quantity::length, "mm", ranges::bore, {0, 0.1}, linear, Presence::unusual,
                 [](const Section& s) { return s.area ? std::nullopt : Value(s.bore); }, [](Section& s, double v) { s.bore = v; },
                 nullptr, With::diameter},
    SectionField{"end_diameter", "end diameter", "", "Outer diameter of a cone at the end towards the rock; `diameter` is that of the rear end, and the bore is constant",
                 Quantity::length, "mm", ranges::diameter, {0.015, 0.25}, linear, Presence::optional,
                 [](const Section& s) { return s.area ? std::nullopt : s.endDiameter; }, [](Section& s, double v) { s.endDiameter = v; },
                 [](Section& s) { s.endDiameter.reset(); }, With::diameter},
    SectionField{"end_area", "end area", "", "Cross-section of a cone at the end towards the rock; `area` is that of the rear end",
                 Quantity::area, "mm^2", ranges::area, {1e-4, 5e-2}, logarithmic, Presence::optional,
                 [](const Section& s) { return s.area ? s.endArea : std::nullopt; }, [](Section& s, double v) { s.endArea = v; },
                 [](Section& s) { s.endArea.reset(); }, With::area},
    SectionField{"youngs_modulus", "Young's modulus", "E", "Young's modulus (default: that of the material)",
                 Quantity::stress, "GPa", ranges::modulus, usual_ranges::modulus, linear, Presence::optional,
                 [](const Section& s) { return s.youngsModulus; }, [](Section& s, double v) { s.youngsModulus = v; },
                 [](Section& s) { s.youngsModulus.reset(); }},
    SectionField{"density", "density", "ρ", "Density (default: that of the material)",
                 Quantity::density, "kg/m^3", ranges::density, usual_ranges::density, linear, Presence::optional,
                 [](const Section& s) { return s.density; }, [](Section& s, double v) { s.density = v; },
                 [](Section& s) { s.density.reset(); }},
    SectionField{"mass_after", "attached mass", "M", "Lumped mass at the end towards the rock; for the last section of a string, the mass of the bit",
                 Quantity::mass, "kg", ranges::mass, {0, 50}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.massAfter); }, [](Section& s, double v) { s.massAfter = v; }},
    SectionField{"loss", "loss", "η", "Share of the energy of a wave that is lost in the joint at the end towards the rock: 3 to 6 % with tight threads, 6 to 10 % with worn threads (trade texts, not measured)",
                 Quantity::share, "%", ranges::share, {0, 0.3}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.loss); }, [](Section& s, double v) { s.loss = v; }},
    SectionField{"attenuation", "attenuation", "α", "Decay of the amplitude of a wave per length",
                 Quantity::attenuation, "1/m", ranges::attenuation, {0, 0.1}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.attenuation); }, [](Section& s, double v) { s.attenuation = v; }},
    SectionField{"yield_strength", "yield strength", "", "Stress up to which the section stays elastic; a larger one gives a warning",
                 Quantity::stress, "MPa", ranges::strength, usual_ranges::yieldStrength, linear, Presence::optional,
                 [](const Section& s) { return s.yieldStrength; }, [](Section& s, double v) { s.yieldStrength = v; },
                 [](Section& s) { s.yieldStrength.reset(); }},
    SectionField{"fatigue_strength", "fatigue strength", "", "Tensile stress that the section endures blow after blow; a larger one gives a warning",
                 Quantity::stress, "MPa", ranges::strength, usual_ranges::fatigueStrength, linear, Presence::optional,
                 [](const Section& s) { return s.fatigueStrength; }, [](Section& s, double v) { s.fatigueStrength = v; },
                 [](Section& s) { s.fatigueStrength.reset(); }},
};
// clang-format on

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

const Unit& SectionField::displayUnit() const {
    const Unit* found = findUnit(quantity, unit);
    assert(found);
    return *found;
}

std::span<const SectionField> sectionFields() {
    return fieldTable;
}

const SectionField* findSectionField(std::string_view key) {
    const auto found = std::ranges::find(fieldTable, key, &SectionField::key);
    return found == fieldTable.end() ? nullptr : &*found;
}

bool areRivals(const SectionField& a, const SectionField& b) {
    const auto isOf = [](const SectionField& field, With with, std::string_view start) {
        return field.with == with || field.key == start;
    };
    const auto replaces = [&](const SectionField& one, const SectionField& other) {
        return isOf(one, With::area, "area") && isOf(other, With::diameter, "diameter");
    };
    return &a == &b || replaces(a, b) || replaces(b, a);
}

Message rangeProblem(const SectionField& field, double value) {
    return field.hard.problem(value, unitOfRange(field.quantity, field.displayUnit()));
}

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
