// SPDX-License-Identifier: GPL-3.0-or-later
// Files of presets: YAML read as strictly as scenarios. The format is explained in resources/presets.
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

/// The newest format number of preset files that this program reads.
inline constexpr int presetFormat = 1;

/// A file that is larger is none.
inline constexpr std::size_t maximumPresetBytes = std::size_t{1} << 20;

/// The first key of such a file.
inline constexpr std::string_view presetKey = "drillwave_presets:";

/// Contents of such a file, each kind in the order of the file.
struct PresetFile {
    std::vector<Preset> presets;                ///< of rods, hammers and rocks
    std::vector<SectionPreset> sectionPresets;  ///< of pieces of drill strings
};

/// `source` names the text in messages. Throws ScenarioError with every problem and its place: unknown keys,
/// values without a unit or a source, hammers, rods and sections that could not be.
PresetFile parsePresets(std::string_view text, const std::string& source);

/// Does the same for a file of at most 1 MiB.
PresetFile loadPresets(const std::string& path);

/// The presets of resources/presets, built into the program.
const PresetFile& builtInPresetFile();
std::span<const Preset> builtInPresets();
std::span<const SectionPreset> builtInSectionPresets();

// Source of the values of a preset, in the file that uses it.

/// Returns the source of a value according to the preset; empty for values that are not of it.
std::string presetSource(const Preset& preset, const SavedValue& saved);

/// The file of a scenario that has just taken the preset, as writeScenario() writes it, with that remark as a
/// comment behind each value of the preset. A comment that is there stays in its place; values in braces, of
/// which one comment would be about all, get none. Throws ScenarioError as writeScenario() does.
std::string writeWithPreset(const ScenarioDocument& document, const Preset& preset);

}  // namespace drillwave
