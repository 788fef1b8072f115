// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a section of a hammer or a string: the rows of the table of parameters that stand for as
// many parameters as there are sections.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/model/parameter.h"

namespace drillwave {

/// A number of a section.
struct SectionField {
    std::string_view key;      ///< in a file, e.g. "length"
    std::string_view label;    ///< words, e.g. "length"
    std::string_view symbol;   ///< may be empty
    std::string_view meaning;  ///< one line
    Quantity quantity;
    std::string_view unit;  ///< customary
    Range hard;
    Range plausible;
    SliderScale slider;
    Presence presence;
    std::optional<double> (*value)(const Section&);
    void (*assign)(Section&, double);
    void (*clear)(Section&) = nullptr;  ///< nullptr where there is always a value
    /// What it goes with: an outer diameter, or an area in its place.
    enum class With { both, diameter, area } with = With::both;

    const Unit& displayUnit() const;
    /// Whether it has a meaning for that section.
    bool applies(const Section& section) const {
        return with == With::both || (with == With::area) == section.area.has_value();
    }
};

/// All of them, in the order of a file.
std::span<const SectionField> sectionFields();

/// The field of that key, or nullptr.
const SectionField* findSectionField(std::string_view key);

/// Whether setting the one undoes what setting the other did: an area, and diameter or bore, of a cone those
/// of its end among them.
bool areRivals(const SectionField& a, const SectionField& b);

/// Why `value` (SI) is outside the hard range: "must be greater than 0"; empty when it is inside.
Message rangeProblem(const SectionField& field, double value);

}  // namespace drillwave
