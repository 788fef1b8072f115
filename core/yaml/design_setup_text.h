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

/// Returns the single values of the block `design`, such as the number of samples, in the form used for all
/// values of a scenario file. Lists are left out.
std::vector<SavedValue> savedDesignValues(const DesignSetup& setup);

/// Returns the key and the items of every list in the block `design`, with the items as YAML. Empty lists are
/// included.
std::vector<std::pair<std::string_view, std::vector<std::string>>> designLists(const DesignSetup& setup);

/// Returns the block `design` as in a new file, "design:\n  uncertain:\n …"; empty for empty settings.
std::string designSetupText(const DesignSetup& setup);

}  // namespace drillwave
