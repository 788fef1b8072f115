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

/// Returns the settings of a design study in the block `design` of a file; empty settings if there is none.
/// Reports values of the wrong type (text, truth value or number). The contents of the texts are checked
/// later, when the study starts.
DesignSetup readDesignSetup(SectionReader& reader, const YamlEntries& file);

/// Returns the settings of a design study that are single values, such as the number of samples, for writing
/// to a scenario file. Lists are left out; designLists() returns them.
std::vector<SavedValue> savedDesignValues(const DesignSetup& setup);

/// Returns the key and the items of every list in the block `design`, with the items as YAML. Empty lists are
/// included.
std::vector<std::pair<std::string_view, std::vector<std::string>>> designLists(const DesignSetup& setup);

/// Returns the block `design` of a new scenario file, "design:\n  uncertain:\n …"; an empty text if `setup`
/// is empty.
std::string designSetupText(const DesignSetup& setup);

}  // namespace drillwave
