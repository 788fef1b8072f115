// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_preset.h"

#include <cassert>

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

std::string description(const SectionPreset& preset, const ReadingStyle& style) {
    std::string text;
    for (const Section& section : preset.sections)
        text += (text.empty() ? "" : ", ") + style.withDecimalSign(sizeText(section));
    if (preset.velocity) text += ", " + style.quantity(*preset.velocity, Quantity::velocity);
    return text + " — " + style.said(Message::ofTable(preset.source));
}

Hammer withPiston(Hammer hammer, const SectionPreset& piston) {
    assert(piston.kind == SectionPresetKind::piston);
    hammer.sections = piston.sections;
    if (piston.velocity) hammer.velocity = *piston.velocity;
    return hammer;
}

}  // namespace drillwave
