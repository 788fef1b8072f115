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

/// Returns the descriptions of the options that both commands `sweep` and `table` accept.
std::vector<OptionSpec> rowOptionSpecs();

/// Returns the description of the option --shard I/N, which computes only part I of N parts of the rows.
OptionSpec shardOptionSpec();
/// Returns the description of the option --resume, which continues the rows of an interrupted run.
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
    /// Whether --resume is given. The run then continues the rows of an interrupted run, and keeps its
    /// finished rows if it is interrupted itself.
    bool resumes = false;
    MethodChoice method;
    /// Largest work permitted for one row [wave pieces, the unit of work of the exact solver].
    long workLimit = defaultWorkLimit;

    /// Returns the output columns; with `--outputs all`, all those that are available for `scenario`.
    std::vector<OutputColumn> columnsFor(const Scenario& scenario) const;
};

/// Returns the values of the options of `sweep` or `table`. If FILE is a result, `method` is the method that
/// solved it, and the default of --method. Throws CommandError (usage).
RowOptions rowOptions(const Arguments& arguments, const std::optional<MethodChoice>& method);

/// Noun for one computed case in messages on failures: "row" of a table, or "point" of a map.
enum class RowNoun { row, point };

/// Returns the reasons why rows or points failed, with their numbers: "2 rows: its waves have more polynomial
/// pieces than …". Advises a larger --work-limit if that is a reason.
Message reasonsOf(const RowCounts& counts, RowNoun noun, long workLimit);

/// Returns the value of --work-limit [wave pieces, the unit of work of the exact solver], or `fallback`
/// without it.
long workLimitOf(const Arguments& arguments, long fallback = defaultWorkLimit);
/// Returns the limits of work for one blow, for commands without rows. Unless --work-limit is given, drill
/// strings have a larger default limit, because they often take seconds.
WorkLimits workLimitsOf(const Arguments& arguments);
/// Returns the description of the option --work-limit, for commands that solve single blows.
OptionSpec workLimitSpec();
/// Returns the message "FILE: could not be solved: REASON".
Message couldNotBeSolved(const std::string& path, const Message& reason);
/// Returns the reason why a blow was not solved. If the reason is the work limit, appends "; --work-limit,
/// now 1000000, permits more".
Message reasonWithHint(const Message& reason, long workLimit);
/// Returns the reason why a blow was not solved. If the reason is the work limit, appends the advice to raise
/// --work-limit, with its present value.
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario);
/// Returns the reason why a blow was not solved. If `hindrance` is the work limit, appends the advice to
/// raise --work-limit, with its present value.
Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario,
                       Hindrance hindrance);

/// Returns the command line that computes the same rows again, for their record. Leaves out options for the
/// file and for speed, such as -o and -j.
std::string commandText(std::string_view command, const Arguments& arguments);

/// Returns the record (FILE.csv.yaml) that describes how rows with these columns are computed by `command`.
/// The caller adds its axes or cases. Throws ScenarioError if the scenario is too large for a file.
RowRecord recordOf(std::string_view command, const Arguments& arguments, const RowOptions& options,
                   std::span<const OutputColumn> columns, const ScenarioDocument& base, std::uint64_t rows);

/// Checks that the file of rows and the record that describes it (FILE.csv.yaml) can be written. Call it
/// before any computation. Throws CommandError: usage if an input would be overwritten; unwritable output.
void checkRows(const RowOptions& options, const Arguments& arguments, const ScenarioDocument& document);

/// Writes the file of rows, the record that describes it (FILE.csv.yaml), and the files in `beside`, such as
/// pictures. Writes either all of them or none. Throws CommandError: unwritable output; interrupted.
void commitRows(OutputFile& rows, const RowOptions& options, RowRecord record, std::vector<NamedFile> beside,
                const Interruption& interruption);

/// Returns the message "2 of 20 rows could not be solved: their output cells are empty".
Message unsolvedRows(std::uint64_t unsolved, std::uint64_t rows);

/// Function that computes the rows of a sweep or table. It leaves out the first `done` rows, which an earlier
/// run completed. It sends the others to `sink` and reports to `progress`.
using RunRows =
    std::function<RowCounts(std::stop_token, RowSink& sink, const RowProgress& progress, std::uint64_t done)>;

/// Function that draws the rows as picture files; returns nothing if there is nothing to draw.
using DrawRows = std::function<std::vector<NamedFile>()>;

/// Computes rows, writes them to the file of -o together with their record (FILE.csv.yaml) and the pictures
/// of `draw`, and returns ExitCode::done. Shows the progress in the language of `style`, and announces runs
/// of over ten minutes. An interruption leaves no file, or with --resume the completed rows. Throws
/// CommandError: unwritable output, also if the disk has too little space; unsolved if rows failed, with
/// their number and reasons; interrupted.
ExitCode writeRows(const RunRows& run, const RowRecord& record, const RowOptions& options,
                   const Interruption& interruption, const ReadingStyle& style, const DrawRows& draw = {});

}  // namespace drillwave
