// SPDX-License-Identifier: GPL-3.0-or-later
// --rod, --hammer, --rock and --presets.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

/// The options, for a command's table of options.
std::vector<OptionSpec> presetOptionSpecs();

/// "rod", "hammer", "rock": the option that takes a preset.
std::string_view name(PresetKind kind);

/// Puts the values of the presets that are named into a scenario, which `path` names. `arePresetsChosen`:
/// --presets is also about presets that are designs of a study. Throws CommandError.
void applyPresets(Scenario& scenario, const Arguments& arguments, const std::string& path,
                  bool arePresetsChosen = false);

/// The presets of a file, of standard input ("-") or a pipe, or the built-in ones without one. Throws
/// CommandError.
PresetFile presetsOf(const std::optional<std::string>& path, const ReadingStyle& style);
/// Returns the presets in a text that `path` names.
PresetFile parsedPresets(std::string_view text, const std::string& path);

}  // namespace drillwave
