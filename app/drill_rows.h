// SPDX-License-Identifier: GPL-3.0-or-later
// Files that `drill` writes: a CSV file with one row per blow or value, and a record that describes it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/arguments.h"
#include "app/output_file.h"
#include "core/archive/row_record.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Throws CommandError (unwritable output) if the CSV file, or the record that describes it (FILE.csv.yaml),
/// cannot be written. Call it before any computation.
void checkDrillRows(const std::string& file, const Arguments& arguments, const ScenarioDocument& document,
                    Overwrite overwrite);

/// Returns the record (RowRecord) that describes how the rows were computed, with command, scenario and
/// number of rows. The caller adds axes and outputs.
RowRecord drillRecord(const Arguments& arguments, const std::string& scenarioText, std::uint64_t rows);

/// Returns the file that describes how the rows were computed, "blows.csv.yaml" for "blows.csv". It includes
/// the size and checksum of `rows`, the contents of `file`.
NamedFile drillRecordBeside(const std::string& file, RowRecord record, std::string_view rows);

}  // namespace drillwave
