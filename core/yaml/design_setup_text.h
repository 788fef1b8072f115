// SPDX-License-Identifier: GPL-3.0-or-later
// The block `design` of a scenario file (files §1.5): read and written.
#pragma once

#include <string>
#include <string_view>

#include "core/model/design_setup.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// Key of the block.
inline constexpr std::string_view designKey = "design";

/// Reads the block; reports what is no list of texts, no truth value and no number. An absent block gives an
/// empty set-up. The study checks the meaning of the texts.
DesignSetup readDesignSetup(SectionReader& reader, const YamlEntries& file);

/// Returns the block in its customary form, "design:\n  uncertain:\n …"; empty for an empty set-up.
std::string designSetupText(const DesignSetup& setup);

}  // namespace drillwave
