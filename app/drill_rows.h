// SPDX-License-Identifier: GPL-3.0-or-later
// The file of rows that `drill` writes, and the record beside it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/arguments.h"
#include "app/output_file.h"
#include "core/archive/row_record.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Checks before any computation whether a file of rows can be written, with a record beside it. Throws
/// CommandError (unwritable output).
void checkDrillRows(const std::string& file, const Arguments& arguments, const ScenarioDocument& document,
                    Overwrite overwrite);

/// Returns the record of the rows and of how to get them, without axes and outputs.
RowRecord drillRecord(const Arguments& arguments, const std::string& scenarioText, std::uint64_t rows);

/// "blows.csv.yaml" with that in it, of a file with these rows.
NamedFile drillRecordBeside(const std::string& file, RowRecord record, std::string_view rows);

}  // namespace drillwave
