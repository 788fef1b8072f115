// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a section of a hammer or drill string, such as its length. Each row stands for one parameter per
// section.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/model/drill_string.h"
#include "core/model/parameter.h"

namespace drillwave {

/// Number that describes a section, such as its length, with its names, unit and allowed range.
struct SectionField {
    std::string_view key;      ///< key in a file, "length"
    std::string_view label;    ///< name in forms and messages, "length"
    std::string_view symbol;   ///< symbol, "L"; may be empty
    std::string_view meaning;  ///< explanation in one line
    Quantity quantity;
    std::string_view unit;  ///< default unit for display and files, "mm"
    Range hard;
    Range plausible;
    SliderScale slider;
    Presence presence;
    std::optional<double> (*value)(const Section&);
    void (*assign)(Section&, double);
    /// Function that makes the value "not given"; nullptr if the number always has a value.
    void (*clear)(Section&) = nullptr;
    /// Sections to which this number applies: all, or only those given by outer diameter or by area.
    enum class With { both, diameter, area } with = With::both;

    const Unit& displayUnit() const;
    /// Returns whether a section can have this number: an area, for example, excludes a diameter.
    bool applies(const Section& section) const {
        return with == With::both || (with == With::area) == section.area.has_value();
    }
};

/// Returns descriptions of all numbers that a section may have, such as its length, in the order of a
/// scenario file.
std::span<const SectionField> sectionFields();

/// Returns the description of the number of a section with this key, such as "length", or nullptr.
const SectionField* findSectionField(std::string_view key);

/// Returns whether setting one of two numbers of a section undoes the other. This holds for a number and
/// itself, and for an area and a diameter or bore. For the end of a cone towards the rock it holds for its
/// area and diameter.
bool areRivals(const SectionField& a, const SectionField& b);

/// Returns why `value` (SI) is outside the allowed range: "must be greater than 0"; empty if it is inside.
Message rangeProblem(const SectionField& field, double value);

// Keys of the numbers of sections, by name or by number. "string.adapter.length" means all sections with that
// name, where `_` also stands for a blank. "string.3.length" and "hammer.1.diameter" mean one section,
// counted from 1 with repeats expanded. A section inside a repeat stands in the file once, so that setting
// any of its copies sets all.

/// Section or sections that a key refers to, and the number that it sets. Sections are given by name or by
/// position.
struct SectionAddress {
    enum class Chain { hammer, string };
    Chain chain = Chain::string;
    std::string name;  ///< name of the sections, "adapter"; empty if a position is given
    /// Number of the section in hammer or string, from 1 with repeats expanded; 0 if a name is given.
    std::uint64_t place = 0;
    const SectionField* field = nullptr;

    /// Returns whether the address is given by name and `section` is that name, where `_` also matches a
    /// blank.
    bool isCalled(std::string_view section) const;
    /// Returns the words for the section in messages: "adapter", "section 3", "hammer section 1".
    std::string words() const;
    /// Returns whether both addresses have the same name or position, and both are in the hammer or both in
    /// the string.
    bool hasSameSections(const SectionAddress& other) const;
};

/// Returns which section and which of its numbers a key such as "string.3.length" means, even if there is no
/// such section. Returns nullopt for any other key.
std::optional<SectionAddress> findSectionAddress(std::string_view key);

/// Returns the key of the section at a position: "string.3".
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place);
/// Returns the key of a number of a section, "string.3.length". `place` is the position of the section, here
/// 3, counted from 1; `field` is the last part.
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place, std::string_view field);

/// Calls `visit(section, index)` for every section that the address refers to. The index counts the sections
/// of its hammer or string as listed in the file, from 0.
template <class String, class Visit>
void visitNumberedSections(const SectionAddress& address, String& drillString, const Visit& visit) {
    std::size_t first = 0;  // index of the first section of the list
    const auto visitList = [&](auto& sections, std::uint64_t before, std::uint64_t repeat) {
        const std::uint64_t count = sections.size();
        for (std::uint64_t i = 0; i < count; ++i) {
            const bool inside = address.place > before && address.place - before <= repeat * count;
            const bool here = address.place == 0 ? address.isCalled(sections[i].name)
                                                 : inside && (address.place - before - 1) % count == i;
            if (here) visit(sections[i], first + i);
        }
        first += count;
        return before + repeat * count;
    };
    if (address.chain == SectionAddress::Chain::hammer) {
        visitList(drillString.hammer.sections, 0, 1);
        return;
    }
    std::uint64_t before = 0;
    for (auto& part : drillString.parts)
        before = visitList(part.sections, before, static_cast<std::uint64_t>(std::max(part.repeat, 0)));
}

/// Calls `visit(section)` for each section to which the address refers. A name may refer to several sections.
template <class String, class Visit>
void visitSections(const SectionAddress& address, String& drillString, const Visit& visit) {
    visitNumberedSections(address, drillString, [&](auto& section, std::size_t) { visit(section); });
}

/// Returns why an address matches no section: "no section of the string is called `adaptor`; did you mean
/// `adapter`?".
Message whyNoneThere(const SectionAddress& address, const DrillString& drillString);

/// Returns the key of a section that is most similar to a mistyped one; empty if none is similar. As no
/// scenario is given, names of sections are not known.
std::string nearestSectionKey(std::string_view key);

/// Returns why a section cannot have this name: "must be …"; empty if it can.
Message sectionNameProblem(std::string_view name);

}  // namespace drillwave
