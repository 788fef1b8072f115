// SPDX-License-Identifier: GPL-3.0-or-later
// Options --rod, --hammer, --rock and --presets, which apply presets to a scenario.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/study/design/design_texts.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

/// Returns the descriptions of the options --rod, --hammer, --rock and --presets.
std::vector<OptionSpec> presetOptionSpecs();

/// Returns the name of the option that selects a preset of a kind: "rod", "hammer" or "rock".
std::string_view name(PresetKind kind);

/// Sets the values of the presets chosen on the command line in a scenario; `path` names it in messages.
/// Throws CommandError, also if --presets is given without choosing a preset. `arePresetsChosen` permits
/// this, because presets are then used as design variables.
void applyPresets(Scenario& scenario, const Arguments& arguments, const std::string& path,
                  bool arePresetsChosen = false);

/// Returns the presets of a file, of standard input ("-") or of a pipe; without a path, the built-in ones.
/// Throws CommandError.
PresetFile presetsOf(const std::optional<std::string>& path, const ReadingStyle& style);
/// Returns a source of presets: the file of --presets, or the built-in presets without this option. The file
/// is read once, when the first name is looked up. `arguments` must outlive the result.
PresetLookup presetLookup(const Arguments& arguments);
/// Returns the presets in the text of a file; `path` names it in messages. Throws CommandError.
PresetFile parsedPresets(std::string_view text, const std::string& path);

}  // namespace drillwave
