// SPDX-License-Identifier: GPL-3.0-or-later
// Options that the commands `sweep` and `table` share: outputs, threads, parts, and the file for the rows.
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

/// Returns the options that `sweep` and `table` share, for their tables of options.
std::vector<OptionSpec> rowOptionSpecs();

/// Returns the option --shard, which computes one part of the rows.
OptionSpec shardOptionSpec();
/// Returns the option --resume, which continues the rows of an interrupted run.
OptionSpec resumeOptionSpec();

/// Returns the help on --outputs: all names of outputs with their meanings.
std::string outputHelp(const ReadingStyle& style);

/// Returns the number of threads given by -j, by default all that are available (at most 1024). Throws
/// CommandError (usage).
int jobsOf(const Arguments& arguments);

/// Values of the options that `sweep` and `table` share.
struct RowOptions {
    std::vector<OutputColumn> columns;
    OutputUnits units = OutputUnits::dimensionless;
    bool allOutputs = false;  ///< `--outputs all` was given: columnsFor() returns all outputs available
    int jobs = 1;
    Shard shard;
    std::string path;  ///< file for the rows; "-" is standard output
    Overwrite overwrite = Overwrite::refused;
    /// Whether --resume is given, which continues the rows of an interrupted run, and keeps the finished rows
    /// if interrupted again.
    bool resumes = false;
    MethodChoice method;
    /// Largest work of one row [wave pieces, the unit of work of the exact solver].
    long workLimit = defaultWorkLimit;

    /// Returns the output columns; with `--outputs all`, all those that are available for `scenario`.
    std::vector<OutputColumn> columnsFor(const Scenario& scenario) const;
};

/// Returns the values of the options. `method` is the one by which FILE was solved if FILE is a result; it is
/// the default for --method. Throws CommandError (usage).
RowOptions rowOptions(const Arguments& arguments, const std::optional<MethodChoice>& method);

/// Word for one solved case in messages on failures: "row" or "point".
enum class RowNoun { row, point };

/// Returns why rows or points failed, with their numbers: "2 rows: its waves have more polynomial pieces than
/// …". Advises a larger --work-limit if that is the reason.
Message reasonsOf(const RowCounts& counts, RowNoun noun, long workLimit);

/// Returns the value of --work-limit [wave pieces, the unit of work of the exact solver], or `fallback`
/// without it.
long workLimitOf(const Arguments& arguments, long fallback = defaultWorkLimit);
/// Returns the limits of work for one blow, for commands without rows. For drill strings, which often take
/// seconds, --work-limit only replaces the larger default limit if the option is given.
WorkLimits workLimitsOf(const Arguments& arguments);
/// Returns the option --work-limit, for commands that solve single blows.
OptionSpec workLimitSpec();
/// Returns the message "FILE: could not be solved: REASON".
Message couldNotBeSolved(const std::string& path, const Message& reason);
/// Returns a reason, with "; --work-limit, now 1000000, permits more" added if the blow reached that limit.
Message reasonWithHint(const Message& reason, long workLimit);
/// Returns a reason, with the advice to raise --work-limit added if the blow reached its limit from
/// workLimitsOf().
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario);
/// Returns a reason, with the advice to raise --work-limit added if `hindrance` says that this limit stopped
/// the blow.
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario,
                       Hindrance hindrance);

/// Returns the command line that computes the same rows, without options for the file and for speed (-o, -j
/// and others).
std::string commandText(std::string_view command, const Arguments& arguments);

/// Returns the record (FILE.csv.yaml) that describes how rows with these columns are computed by `command`.
/// The caller adds its axes or cases. Throws ScenarioError if the scenario is too large for a file.
RowRecord recordOf(std::string_view command, const Arguments& arguments, const RowOptions& options,
                   std::span<const OutputColumn> columns, const ScenarioDocument& base, std::uint64_t rows);

/// Checks that the file of rows and the record that describes it (FILE.csv.yaml) can be written. Call it
/// before any computation. Throws CommandError: usage if an input would be overwritten; unwritable output.
void checkRows(const RowOptions& options, const Arguments& arguments, const ScenarioDocument& document);

/// Writes the file of rows together with the record that describes it (FILE.csv.yaml) and the files in
/// `beside`, such as pictures: all or none. Throws CommandError: unwritable output; interrupted.
void commitRows(OutputFile& rows, const RowOptions& options, RowRecord record, std::vector<NamedFile> beside,
                const Interruption& interruption);

/// Returns the message "2 of 20 rows could not be solved: their output cells are empty".
Message unsolvedRows(std::uint64_t unsolved, std::uint64_t rows);

/// Function that computes the rows of a sweep or table, except the first `done` ones, which an earlier run
/// completed. It sends them to `sink` and calls `progress`.
using RunRows =
    std::function<RowCounts(std::stop_token, RowSink& sink, const RowProgress& progress, std::uint64_t done)>;

/// Function that draws the results as files; empty if there is nothing to draw.
using DrawRows = std::function<std::vector<NamedFile>()>;

/// Computes the rows, writes them to the file of -o with its record and the pictures of `draw`, and returns
/// ExitCode::done. Shows the progress in the language of `style`. Throws CommandError: unwritable output,
/// also before the disk would be full; unsolved if rows failed, with their number and reasons; interrupted.
/// An interruption leaves no file, or with --resume the completed rows. Announces runs of over ten minutes.
ExitCode writeRows(const RunRows& run, const RowRecord& record, const RowOptions& options,
                   const Interruption& interruption, const ReadingStyle& style, const DrawRows& draw = {});

}  // namespace drillwave
