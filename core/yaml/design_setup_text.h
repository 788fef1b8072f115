// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of the block `design` of a scenario file (files §1.5).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/design_setup.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// Key of the settings of a design study in a scenario file.
inline constexpr std::string_view designKey = "design";

/// Returns the settings in the block `design` of a file; empty settings if it is absent. Reports values of
/// the wrong kind (text, truth value or number). The study checks the meaning of the texts.
DesignSetup readDesignSetup(SectionReader& reader, const YamlEntries& file);

/// Returns the values of the block `design` that are not lists, as SavedValue, the type used for all values
/// of a scenario file.
std::vector<SavedValue> savedDesignValues(const DesignSetup& setup);

/// Returns the keys of all lists of the block `design`, also of empty ones, with their items as YAML.
std::vector<std::pair<std::string_view, std::vector<std::string>>> designLists(const DesignSetup& setup);

/// Returns the block `design` as in a new file, "design:\n  uncertain:\n …"; empty for empty settings.
std::string designSetupText(const DesignSetup& setup);

}  // namespace drillwave
