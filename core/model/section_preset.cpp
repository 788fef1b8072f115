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
