// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_preset.h"

#include <cassert>

#include "core/model/section_field.h"
#include "core/model/section_pieces.h"
#include "core/text/enum_names.h"
#include "core/text/units.h"

namespace drillwave {
std::string_view name(SectionPresetKind kind) {
    static constexpr EnumNames<SectionPresetKind> names{{{SectionPresetKind::piston, "piston"},
                                                         {SectionPresetKind::adapter, "adapter"},
                                                         {SectionPresetKind::coupling, "coupling"},
                                                         {SectionPresetKind::bit, "bit"}}};
    return names[kind];
}

namespace {

/// "yield strength 900 MPa, fatigue strength 250 MPa — assumed" of the first section, which stands for all.
std::string strengthText(const SectionPreset& preset, const ReadingStyle& style) {
    std::string text;
    for (const char* key : {"yield_strength", "fatigue_strength"}) {
        const SectionField& field = *findSectionField(key);
        const std::optional<double> value = field.value(preset.sections.front());
        if (!value) continue;
        text += (text.empty() ? "" : ", ") + style.said(Message::ofTable(field.label)) + " " +
                style.quantity(*value, field.quantity);
    }
    return text + " — " + style.said(Message::ofTable(preset.strengthSource));
}

}  // namespace

std::string description(const SectionPreset& preset, const ReadingStyle& style) {
    std::string text;
    for (const Section& section : preset.sections)
        text += (text.empty() ? "" : ", ") + style.withDecimalSign(sizeText(section));
    if (preset.velocity) text += ", " + style.quantity(*preset.velocity, Quantity::velocity);
    text += " — " + style.said(Message::ofTable(preset.source));
    if (!preset.strengthSource.empty()) text += "\n" + strengthText(preset, style);
    return text;
}

Hammer withPiston(Hammer hammer, const SectionPreset& piston) {
    assert(piston.kind == SectionPresetKind::piston);
    hammer.sections = piston.sections;
    if (piston.velocity) hammer.velocity = *piston.velocity;
    return hammer;
}

}  // namespace drillwave
