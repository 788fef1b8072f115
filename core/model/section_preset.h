// SPDX-License-Identifier: GPL-3.0-or-later
// A named piece of a drill string: a piston, an adapter, a coupling, a bit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/drill_string.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"

namespace drillwave {

enum class SectionPresetKind { piston, adapter, coupling, bit };
inline constexpr auto sectionPresetKinds = allValues<SectionPresetKind>;

/// "piston" and so on; its list in a file is called "pistons".
std::string_view name(SectionPresetKind kind);

/// Sections with one source for all of them.
struct SectionPreset {
    SectionPresetKind kind = SectionPresetKind::coupling;
    std::string name;
    std::string source;  ///< never empty; begins with "assumed" where there is none
    std::string
        strengthSource;  ///< the source of yield and fatigue strength; empty where `source` covers them
    std::optional<double> velocity;  ///< [m/s] at impact, of a piston where it is to be set too
    std::vector<Section> sections;   ///< at least one, from the rear; each has the name of the preset
    bool operator==(const SectionPreset&) const = default;
};

/// "300 mm × 50 mm, 250 mm × 38 mm, 10 m/s — assumed", and strengths with their source in a line of their
/// own.
std::string description(const SectionPreset& preset, const ReadingStyle& style);

/// The piston in place of the hammer's sections, and its velocity where it has one. Requires a piston.
Hammer withPiston(Hammer hammer, const SectionPreset& piston);

}  // namespace drillwave
