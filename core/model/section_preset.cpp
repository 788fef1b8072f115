// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_preset.h"

#include <cassert>

#include "core/text/enum_names.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

std::string millimetres(double si) {
    static const Unit& unit = *findUnit(Quantity::length, "mm");
    return formatQuantity(si, Quantity::length, unit);
}

std::string sizeText(const Section& section) {
    std::string text = millimetres(section.length) + " × ";
    if (section.area) {
        const Unit& unit = *findUnit(Quantity::area, "mm^2");
        text += formatQuantity(*section.area, Quantity::area, unit);
        return section.endArea ? text + " … " + formatQuantity(*section.endArea, Quantity::area, unit) : text;
    }
    text += millimetres(section.diameter);
    if (section.endDiameter) text += " … " + millimetres(*section.endDiameter);
    return section.bore > 0 ? text + " / " + millimetres(section.bore) : text;
}

}  // namespace

std::string_view name(SectionPresetKind kind) {
    static constexpr EnumNames<SectionPresetKind> names{{{SectionPresetKind::piston, "piston"},
                                                         {SectionPresetKind::adapter, "adapter"},
                                                         {SectionPresetKind::coupling, "coupling"},
                                                         {SectionPresetKind::bit, "bit"}}};
    return names[kind];
}

std::string description(const SectionPreset& preset) {
    std::string text;
    for (const Section& section : preset.sections) text += (text.empty() ? "" : ", ") + sizeText(section);
    if (preset.velocity)
        text +=
            ", " + formatQuantity(*preset.velocity, Quantity::velocity, *findUnit(Quantity::velocity, "m/s"));
    return text + " — " + preset.source;
}

Hammer withPiston(Hammer hammer, const SectionPreset& piston) {
    assert(piston.kind == SectionPresetKind::piston);
    hammer.sections = piston.sections;
    if (piston.velocity) hammer.velocity = *piston.velocity;
    return hammer;
}

}  // namespace drillwave
