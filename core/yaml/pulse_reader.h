// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer blow of a scenario file: its shape, what that shape needs, and the points of a table.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// Where the points of a table file come from: beside `source`, or given already.
struct TableSource {
    const std::string& source;
    const TablePoints* points = nullptr;
};

/// Reads the section `pulse` into the reader's scenario, whose form is known. True when the only problem of a
/// scenario without others is that its table file cannot be read.
bool readPulse(SectionReader& reader, const YamlEntries& file, const TableSource& tables);

}  // namespace drillwave
