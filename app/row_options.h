// SPDX-License-Identifier: GPL-3.0-or-later
// Options of `sweep` and `table` alike: outputs, threads, parts, and the file that the rows go to.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "core/archive/row_record.h"
#include "core/blow/method.h"
#include "core/disk/whole_folder.h"
#include "core/report/row_csv.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/shard.h"
#include "core/text/message.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// The common options, for both commands' tables of options.
std::vector<OptionSpec> rowOptionSpecs();

/// --shard and --resume, for a table of options.
OptionSpec shardOptionSpec();
OptionSpec resumeOptionSpec();

/// The names for --outputs with their meanings, for the help of commands.
std::string outputHelp(const ReadingStyle& style);

/// Threads by `-j N`, all of them where it is not given. Throws CommandError (usage).
int jobsOf(const Arguments& arguments);

/// Their values.
struct RowOptions {
    std::vector<OutputColumn> columns;
    OutputUnits units = OutputUnits::dimensionless;
    bool allOutputs = false;  ///< `--outputs all`: columnsFor() has those that there are
    int jobs = 1;
    Shard shard;
    std::string path;  ///< "-" is standard output
    Overwrite overwrite = Overwrite::refused;
    bool resumes = false;  ///< keeps rows of a run that ends, and continues those of an earlier one
    MethodChoice method;
    long workLimit = defaultWorkLimit;  ///< wave pieces of a row

    /// Returns the columns for scenarios like this one.
    std::vector<OutputColumn> columnsFor(const Scenario& scenario) const;
};

/// `method` is that of the result which FILE is. Throws CommandError (usage).
RowOptions rowOptions(const Arguments& arguments, const std::optional<MethodChoice>& method);

/// Unit in which failures are counted.
enum class RowNoun { row, point };

/// "2 rows: it needs more wave pieces than permitted …", and what to do about it.
Message reasonsOf(const RowCounts& counts, RowNoun noun, long workLimit);

/// --work-limit, in wave pieces; `fallback` where it is not given.
long workLimitOf(const Arguments& arguments, long fallback = defaultWorkLimit);
/// Returns the limits of one blow, for commands without rows. A string takes seconds more often than a rod:
/// it has the limit of the option only if that is given.
WorkLimits workLimitsOf(const Arguments& arguments);
/// The option of such a command.
OptionSpec workLimitSpec();
/// "FILE: could not be solved: …".
Message couldNotBeSolved(const std::string& path, const Message& reason);
/// Whether a reason is that limit.
bool isAtLimit(const Message& reason);
/// Returns a reason, with "; --work-limit, now 1000000, permits more" after it if that has stopped a blow.
Message reasonWithHint(const Message& reason, long workLimit);
/// Returns the reason for a blow within workLimitsOf(), with the same hint.
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario);
/// Returns the reason in the same way if it is known what has stopped the blow.
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario,
                       Hindrance hindrance);

/// The command that gives the same rows, wherever they go.
std::string commandText(std::string_view command, const Arguments& arguments);

/// The record of a run of `command` that writes these columns: all but its axes or cases. Throws
/// ScenarioError where the scenario is too large for a file.
RowRecord recordOf(std::string_view command, const Arguments& arguments, const RowOptions& options,
                   std::span<const OutputColumn> columns, const ScenarioDocument& base, std::uint64_t rows);

/// Checks before any computation whether rows can be written there, with a record beside a file. Throws
/// CommandError: usage, if an input would be overwritten; unwritable output.
void checkRows(const RowOptions& options, const Arguments& arguments, const ScenarioDocument& document);

/// The file of rows with its record, and with pictures, see StudyPlots::besideFile(). Throws CommandError:
/// unwritable output; interrupted.
void commitRows(OutputFile& rows, const RowOptions& options, RowRecord record, std::vector<NamedFile> beside,
                const Interruption& interruption);

/// "2 of 20 rows could not be solved: their output cells are empty".
Message unsolvedRows(std::uint64_t unsolved, std::uint64_t rows);

/// A run of rows, sweep or table, without the first ones of the part, which are done.
using RunRows =
    std::function<RowCounts(std::stop_token, RowSink& sink, const RowProgress& progress, std::uint64_t done)>;

/// Draws the results; no function if there is nothing to draw.
using DrawRows = std::function<std::vector<NamedFile>()>;

/// Runs into the file of -o and commits it with its record and what is drawn then, with progress on a
/// terminal in that style. Rows that need more than the disk has free are refused, hours of work are
/// announced. Failed rows are counted on stderr, with their reasons, and give ExitCode::unsolvedOrFailed; an
/// interruption leaves no file, or where the run resumes the rows so far.
ExitCode writeRows(const RunRows& run, const RowRecord& record, const RowOptions& options,
                   const Interruption& interruption, const ReadingStyle& style, const DrawRows& draw = {});

}  // namespace drillwave
