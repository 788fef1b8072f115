// What `sweep` and `table` have in common: outputs, threads, parts, and the file that the rows go to.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "core/study/method.h"
#include "core/study/output_column.h"
#include "core/study/rows.h"
#include "core/study/shard.h"

namespace drillwave {

/// The common options, for both commands' tables of options.
std::vector<OptionSpec> rowOptionSpecs();

/// The names for --outputs with their meanings, for the help of both.
std::string outputHelp();

/// Their values.
struct RowOptions {
    std::vector<OutputColumn> columns;
    int jobs = 1;
    Shard shard;
    std::string path;  ///< "-" is standard output
    Overwrite overwrite = Overwrite::refused;
    MethodChoice method;
    long workLimit = defaultWorkLimit;  ///< wave pieces of a row
};

/// Throws CommandError (usage).
RowOptions rowOptions(const Arguments& arguments);

/// A run of rows: sweep or table.
using RunRows =
    std::function<RowCounts(std::stop_token, const WriteText& write, const RowProgress& progress)>;

/// Runs into `out` and commits it, with progress on a terminal. `rows` is how many are expected. Failed rows
/// are counted on stderr, with their reasons, and give ExitCode::unsolvedOrFailed; an interruption leaves no
/// file.
ExitCode writeRows(const RunRows& run, std::uint64_t rows, const RowOptions& options, OutputFile& out,
                   const Interruption& interruption);

}  // namespace drillwave
