// SPDX-License-Identifier: GPL-3.0-or-later
// The block `design` of a scenario file (files §1.5): read and written.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/design_setup.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// Key of the block.
inline constexpr std::string_view designKey = "design";

/// Reads the block; reports what is no list of texts, no truth value and no number. An absent block gives an
/// empty set-up. The study checks the meaning of the texts.
DesignSetup readDesignSetup(SectionReader& reader, const YamlEntries& file);

/// Returns the values of the block that are no lists, as the values of a scenario are saved.
std::vector<SavedValue> savedDesignValues(const DesignSetup& setup);

/// Returns the keys of the lists of the block with their items as YAML; lists without items are among them.
std::vector<std::pair<std::string_view, std::vector<std::string>>> designLists(const DesignSetup& setup);

/// Returns the block in its customary form, "design:\n  uncertain:\n …"; empty for an empty set-up.
std::string designSetupText(const DesignSetup& setup);

}  // namespace drillwave
