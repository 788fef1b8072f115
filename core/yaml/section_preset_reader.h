// SPDX-License-Identifier: GPL-3.0-or-later
// Pistons, adapters, couplings and bits of a file of presets.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/model/section_preset.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// The keys of their lists: "pistons" and so on.
std::span<const std::string_view> sectionPresetLists();

/// Reads those lists. `file` are the entries of the whole file; problems go to the reader.
std::vector<SectionPreset> readSectionPresets(SectionReader& reader, const YamlEntries& file);

}  // namespace drillwave
