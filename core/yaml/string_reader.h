// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of hammer, drill string and their material from a scenario file of format 2 (files §1.3).
#pragma once

#include "core/yaml/section_reader.h"

namespace drillwave {

/// Reads `material`, `hammer`, `string` and `end_time` of a file into the scenario of the reader, which must
/// have the form of a drill string.
void readDrillString(SectionReader& reader, const YamlEntries& file);

/// Reads a list of sections that is not part of a scenario, such as the sections of a preset. `key` is the
/// name of the list in error messages.
std::vector<Section> readSectionList(SectionReader& reader, const YamlNode& list, const std::string& key);

}  // namespace drillwave
