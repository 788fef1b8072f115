// SPDX-License-Identifier: GPL-3.0-or-later
// Files of presets: YAML read as strictly as scenarios. The format is explained in resources/presets.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/file/scenario_file.h"
#include "core/model/preset.h"

namespace drillwave {

/// The newest format number of preset files that this program reads.
inline constexpr int presetFormat = 1;

/// The first key of such a file.
inline constexpr std::string_view presetKey = "drillwave_presets:";

/// The presets of the text, in its order. `source` names it in messages. Throws ScenarioError with every
/// problem and its place: unknown keys, values without a unit or a source, hammers and rods that could not
/// be.
std::vector<Preset> parsePresets(std::string_view text, const std::string& source);

/// The same for a file of at most 1 MiB.
std::vector<Preset> loadPresets(const std::string& path);

/// The presets of resources/presets, built into the program.
std::span<const Preset> builtInPresets();

}  // namespace drillwave
