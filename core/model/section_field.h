// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a section of a hammer or a string: the rows of the table of parameters that stand for as
// many parameters as there are sections.
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

/// A number of a section.
struct SectionField {
    std::string_view key;      ///< in a file, e.g. "length"
    std::string_view label;    ///< words, e.g. "length"
    std::string_view symbol;   ///< may be empty
    std::string_view meaning;  ///< one line
    Quantity quantity;
    std::string_view unit;  ///< default
    Range hard;
    Range plausible;
    SliderScale slider;
    Presence presence;
    std::optional<double> (*value)(const Section&);
    void (*assign)(Section&, double);
    void (*clear)(Section&) = nullptr;  ///< nullptr where there is always a value
    /// Form of the section to which the field applies: given by outer diameter, or by area.
    enum class With { both, diameter, area } with = With::both;

    const Unit& displayUnit() const;
    /// Returns whether the field has a meaning for that section.
    bool applies(const Section& section) const {
        return with == With::both || (with == With::area) == section.area.has_value();
    }
};

/// Returns all fields, in the order of a file.
std::span<const SectionField> sectionFields();

/// The field of that key, or nullptr.
const SectionField* findSectionField(std::string_view key);

/// Returns whether setting the one undoes the other: an area, and diameter or bore, including those of the
/// end of a cone.
bool areRivals(const SectionField& a, const SectionField& b);

/// Why `value` (SI) is outside the hard range: "must be greater than 0"; empty when it is inside.
Message rangeProblem(const SectionField& field, double value);

// Which number of which sections a key is about: "string.adapter.length" (all sections of that name, `_`
// standing for a blank too), "string.3.length" (by place from 1, repeats written out), "hammer.1.diameter". A
// section inside a repeat stands in a file once: whichever of its places is set, it is set in every repeat.

/// Which number of which sections.
struct SectionAddress {
    enum class Chain { hammer, string };
    Chain chain = Chain::string;
    std::string name;         ///< of the sections; empty where a place is given
    std::uint64_t place = 0;  ///< from 1; 0 where a name is given
    const SectionField* field = nullptr;

    /// Whether that is its name, given one.
    bool isCalled(std::string_view section) const;
    /// "adapter", "section 3", "hammer section 1".
    std::string words() const;
    /// Returns whether both are for the same name or place of the same chain.
    bool hasSameSections(const SectionAddress& other) const;
};

/// The address of such a key, whether there is such a section or not; nothing where it is none.
std::optional<SectionAddress> findSectionAddress(std::string_view key);

/// "string.3", the section of that place.
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place);
/// "string.3.length", its number of that key.
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place, std::string_view field);

/// Calls `visit` with every section that the address names, and which of its chain it is in a file, from 0.
template <class String, class Visit>
void visitNumberedSections(const SectionAddress& address, String& drillString, const Visit& visit) {
    std::size_t first = 0;  // of the list
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

/// Calls `visit` with every section that the address names.
template <class String, class Visit>
void visitSections(const SectionAddress& address, String& drillString, const Visit& visit) {
    visitNumberedSections(address, drillString, [&](auto& section, std::size_t) { visit(section); });
}

/// Returns why an address matches no section: "no section of the string is called `adaptor`; did you mean
/// `adapter`?".
Message whyNoneThere(const SectionAddress& address, const DrillString& drillString);

/// Returns the known key of a section that is most like a mistyped one, as far as it is known without a
/// scenario; empty when none is close.
std::string nearestSectionKey(std::string_view key);

/// Returns why a section cannot have that name: "must be …"; empty when it can.
Message sectionNameProblem(std::string_view name);

}  // namespace drillwave
