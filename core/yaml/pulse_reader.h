// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer blow of a scenario file: its shape, what that shape needs, and the points of a table.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/model/validation.h"
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

// The table file of a tabulated pulse: time and force, with their units in the header.

/// The points of the file, or what is wrong with it.
struct PulseTable {
    std::vector<TablePoint> points;
    std::vector<InputProblem> problems;  ///< with `source` and line
    bool unreadable = false;             ///< the file could not be opened or is no text
};

/// Reads what the import of records reads: a column of times and one of forces with their units in the
/// heading, whatever the separator, the decimal sign and the encoding ("time,force" without units in a
/// dimensionless scenario). `path` is
/// the file as opened, `source` how messages name it. At most 16 MiB.
PulseTable readPulseTable(const std::string& path, const std::string& source, ScenarioForm form);

}  // namespace drillwave
