// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of the hammer force from a scenario file: its shape, the values for that shape, and the points of a
// table.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/yaml/section_reader.h"

namespace drillwave {

/// Source of the points of a tabulated hammer force. If `points` is given, these points are used and the
/// table file is not opened. Otherwise the file is read. Its path is relative to that of the scenario file
/// `source`.
struct TableSource {
    const std::string& source;
    const TablePoints* points = nullptr;
};

/// Reads the section `pulse` of a file into the scenario of `reader`, whose member `form` must already be
/// set. Returns true if a table file cannot be read, else false. The caller needs this because a file that
/// cannot be read has another exit code than an invalid scenario.
bool readPulse(SectionReader& reader, const YamlEntries& file, const TableSource& tables);

// Table file of a tabulated hammer force: time and force, with their units in the header.

/// Points read from a table file, or its errors.
struct PulseTable {
    std::vector<TablePoint> points;
    std::vector<InputProblem> problems;  ///< errors with their file (`source`) and line
    bool unreadable = false;             ///< whether the file cannot be opened, or is not text
};

/// Reads the points of a table file of at most 16 MiB: a column of times and one of forces, with their units
/// in the headings. Separator, decimal sign and encoding are detected. In a dimensionless scenario the header
/// is "time,force" without units. `path` is the file, `source` its name in messages.
PulseTable readPulseTable(const std::string& path, const std::string& source, ScenarioForm form);

}  // namespace drillwave
