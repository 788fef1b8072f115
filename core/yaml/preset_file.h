// SPDX-License-Identifier: GPL-3.0-or-later
// Files of presets: YAML, read as strictly as scenario files. The files in resources/presets explain the
// format.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/preset.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {

/// Newest format number of preset files that this program reads.
inline constexpr int presetFormat = 1;

/// Largest size of a preset file in bytes; a larger file is refused.
inline constexpr std::size_t maximumPresetBytes = std::size_t{1} << 20;

/// First key of a preset file.
inline constexpr std::string_view presetKey = "drillwave_presets:";

/// Presets of a preset file, in the order of the file.
struct PresetFile {
    std::vector<Preset> presets;                ///< presets of rods, hammers and rocks
    std::vector<SectionPreset> sectionPresets;  ///< presets of sections of drill strings
};

/// Returns the presets in a text; `source` names it in messages. Throws ScenarioError with all errors and
/// their positions: unknown keys, values without a unit or a source, and invalid hammers, rods or sections.
PresetFile parsePresets(std::string_view text, const std::string& source);

/// Returns the presets in a file of at most 1 MiB. Throws ScenarioError with all errors and their positions.
PresetFile loadPresets(const std::string& path);

/// Returns the presets of resources/presets, which are built into the program.
const PresetFile& builtInPresetFile();
std::span<const Preset> builtInPresets();
std::span<const SectionPreset> builtInSectionPresets();

// Source of the values of a preset, written into the scenario file that uses them.

/// Returns the source that a preset gives for a value of a scenario file. Empty for values that the preset
/// does not set.
std::string presetSource(const Preset& preset, const SavedValue& saved);

/// Returns the text of a scenario file as writeScenario() does. A comment after each value that the preset
/// sets gives its source. Existing comments remain. Maps in braces get no such comment, as it would apply to
/// all of their values. If the comments would make the text larger than 1 MiB, none are added. Throws
/// ScenarioError if the text is larger even without them. Requires a scenario to which the preset was just
/// applied.
std::string writeWithPreset(const ScenarioDocument& document, const Preset& preset);

}  // namespace drillwave
