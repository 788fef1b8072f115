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

/// Returns the options --rod, --hammer, --rock and --presets, for a command's table of options.
std::vector<OptionSpec> presetOptionSpecs();

/// Returns the name of the option that selects a preset of a kind: "rod", "hammer" or "rock".
std::string_view name(PresetKind kind);

/// Sets the values of the presets chosen on the command line in a scenario; `path` names it in messages.
/// Throws CommandError, also if --presets is given but no preset is chosen. This does not apply with
/// `arePresetsChosen`, which means that presets are used as design variables.
void applyPresets(Scenario& scenario, const Arguments& arguments, const std::string& path,
                  bool arePresetsChosen = false);

/// Returns the presets of a file, of standard input ("-") or of a pipe; without a path, the built-in ones.
/// Throws CommandError.
PresetFile presetsOf(const std::optional<std::string>& path, const ReadingStyle& style);
/// Returns a lookup in the file of --presets, or in the built-in presets. Reads the file once, when a name is
/// looked up; `arguments` must outlive it.
PresetLookup presetLookup(const Arguments& arguments);
/// Returns the presets in the text of a file; `path` names it in messages. Throws CommandError.
PresetFile parsedPresets(std::string_view text, const std::string& path);

}  // namespace drillwave
