// SPDX-License-Identifier: GPL-3.0-or-later
// A named set of values for a part of a scenario: a rod, a hammer, a rock.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// The part of a scenario that a preset is for.
enum class PresetKind { rod, hammer, rock };

/// One value and where it is from.
struct PresetValue {
    const Parameter* parameter = nullptr;
    double si = 0;
    std::string source;  ///< never empty; begins with "assumed" where there is none
    bool operator==(const PresetValue&) const = default;
};

/// What it names it sets; everything else of the scenario stays. A rock has a loading curve, named or not.
struct Preset {
    PresetKind kind = PresetKind::rod;
    std::string name;
    std::optional<PulseShape> shape;  ///< of a hammer, else nothing
    std::string shapeSource;
    RockLaw law = RockLaw::bilinear;  ///< of a rock, with its corners in SI
    std::vector<RockCorner> corners;
    std::string lawSource;            ///< empty where the file says nothing of the law
    std::vector<PresetValue> values;  ///< in the order of parameters()
    bool operator==(const Preset&) const = default;
};

/// The scenario with the preset's values; the hammer of a `piston` has the rod's material unless the preset
/// names one. It may be invalid, so validate() it. Requires a scenario in physical units, and for a rod and a
/// hammer one of a uniform rod.
Scenario withPreset(Scenario scenario, const Preset& preset);

/// Whether taking the preset would change nothing; never where it cannot be taken.
bool matches(const Preset& preset, const Scenario& scenario);

/// "soft rock — weiches Gestein": the name of a preset, as commands take it, and what it is to a reader in
/// another language.
std::string nameFor(const std::string& name, const ReadingStyle& style);

/// "diameter: 38 mm — nominal", one line for the shape or the law and for each value.
std::string description(const Preset& preset, const ReadingStyle& style);

}  // namespace drillwave
