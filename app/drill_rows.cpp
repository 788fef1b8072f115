// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drill_rows.h"

#include <filesystem>

#include "app/output_file.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/archive/result_files.h"

namespace drillwave {

void checkDrillRows(const std::string& file, const Arguments& arguments, const ScenarioDocument& document,
                    Overwrite overwrite) {
    checkOutputIsNoInput(file, arguments, document);
    checkOutput(file, overwrite);
    if (isStream(file)) return;
    checkOutputIsNoInput(recordName(file), arguments, document);
    checkOverwrite(recordName(file), overwrite);
}

NamedFile drillRecordBeside(const std::string& file, RowRecord record, std::string_view rows) {
    record.file = sumOf(inCsvSigns(rows));  // as the file is written
    return {recordName(std::filesystem::path(file).filename().string()), recordText(record)};
}

RowRecord drillRecord(const Arguments& arguments, const std::string& scenarioText, std::uint64_t rows) {
    return {.command = commandText("drill", arguments),
            .method = {},
            .rows = rows,
            .shard = {},
            .axes = {},
            .cases = {},
            .outputs = {},
            .scenario = scenarioText};
}

}  // namespace drillwave
