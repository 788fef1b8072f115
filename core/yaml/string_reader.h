// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer, string and their material, as a file of format 2 has them (files §1.3).
#pragma once

#include "core/yaml/section_reader.h"

namespace drillwave {

/// Reads `material`, `hammer`, `string` and `end_time` into the reader's scenario, which is one of a string.
void readDrillString(SectionReader& reader, const YamlEntries& file);

/// Sections that stand in a list elsewhere; `key` names it in messages.
std::vector<Section> readSectionList(SectionReader& reader, const YamlNode& list, const std::string& key);

}  // namespace drillwave
