// SPDX-License-Identifier: GPL-3.0-or-later
// Where the values of a preset are from, told by the file that has taken them.
#pragma once

#include <string>

#include "core/model/preset.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {

/// Where the preset says that the value is from; empty for values that are not of it.
std::string presetSource(const Preset& preset, const SavedValue& saved);

/// The file of a scenario that has just taken the preset, as writeScenario() writes it, with that remark as a
/// comment behind each value of the preset. A comment that is there stays in its place; values in braces, of
/// which one comment would be about all, get none. Throws ScenarioError as writeScenario() does.
std::string writeWithPreset(const ScenarioDocument& document, const Preset& preset);

}  // namespace drillwave
