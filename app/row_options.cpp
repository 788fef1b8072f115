// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/row_options.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "app/method_options.h"
#include "app/progress_bar.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/kept_rows.h"
#include "core/archive/result_scenario.h"
#include "core/archive/row_record.h"
#include "core/disk/file_bytes.h"
#include "core/model/blow_traits.h"
#include "core/numeric/available_threads.h"
#include "core/study/rows/study_plan.h"
#include "core/text/decimal_text.h"
#include "core/text/message.h"
#include "core/wave/work_limit.h"

namespace drillwave {

namespace {

constexpr long maximumJobs = 1024;

OutputUnits unitsOf(const Arguments& arguments) {
    return arguments.has("si") ? OutputUnits::si : OutputUnits::dimensionless;
}

OutputChoice outputsOf(const Arguments& arguments) {
    OutputChoice choice = chooseOutputs(arguments.value("outputs").value_or("cor"), unitsOf(arguments));
    if (!choice.problem.isEmpty()) throw CommandError(ExitCode::usage, about("--outputs", choice.problem));
    return choice;
}

/// Options that change the file of the rows or the speed, but not the rows.
constexpr std::string_view aboutTheFile[] = {"o", "force", "j", "plots", "gaps", "resume"};

Shard shardOf(const Arguments& arguments) {
    const std::string text = arguments.value("shard").value_or("1/1");
    const std::optional<Shard> shard = parseShard(text);
    if (!shard)
        throw CommandError(ExitCode::usage, Message(translatable("--shard %1: needs I/N, 1 <= I <= N <= %2"),
                                                    {shortened(text), std::to_string(maximumShards)}));
    return *shard;
}

Message withLimitHint(const Message& reason, long workLimit) {
    return {translatable("%1; --work-limit, now %2, permits more"), {reason, std::to_string(workLimit)}};
}

/// Returns the work limit for a blow, whose default is that of workLimitsOf().
long limitOf(const Arguments& arguments, const Scenario& scenario) {
    return workLimitOf(arguments, studyPlan(scenario).workLimit);
}

/// Rows that are kept have a file to be kept for, and are not in memory to be drawn.
void checkResumes(const Arguments& arguments) {
    if (isStream(arguments.value("o").value_or("-")))
        throw CommandError(ExitCode::usage,
                           translatable("--resume applies to the file of -o; add -o FILE.csv"));
    for (const char* option : {"plots", "level", "json"})
        if (arguments.has(option))
            throw CommandError(ExitCode::usage,
                               Message(translatable("%1 needs the rows in one run; leave out --resume"),
                                       {std::string("--") + option}));
}

/// Formats "2 rows", followed by a reason.
Message countOf(std::uint64_t count, RowNoun noun) {
    if (noun == RowNoun::row) return counted(count, translatable("%1 row"), translatable("%1 rows"));
    return counted(count, translatable("%1 point"), translatable("%1 points"));
}

}  // namespace

Message reasonsOf(const RowCounts& counts, RowNoun noun, long workLimit) {
    Message text;
    std::uint64_t told = 0;
    bool atLimit = false;
    for (const RowFailure& failure : counts.failures) {
        text = joined(std::move(text), "%1; %2", about(countOf(failure.rows, noun), failure.reason));
        told += failure.rows;
        atLimit |= isWorkLimit(failure.reason);
    }
    if (told < counts.failed)
        text = {translatable("%1; %2 for other reasons"), {text, std::to_string(counts.failed - told)}};
    return atLimit ? withLimitHint(text, workLimit) : text;
}

long workLimitOf(const Arguments& arguments, long fallback) {
    return arguments.number("work-limit", fallback, 1, mostWorkLimit);
}

WorkLimits workLimitsOf(const Arguments& arguments) {
    const long pieces = workLimitOf(arguments);
    if (!arguments.has("work-limit")) return {.pieces = pieces};
    return {.pieces = pieces, .cells = cellsOfPiece * pieces};
}

Message reasonWithHint(const Message& reason, long workLimit) {
    return isWorkLimit(reason) ? withLimitHint(reason, workLimit) : reason;
}

Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario) {
    return reasonWithHint(reason, limitOf(arguments, scenario));
}

Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario,
                       Hindrance hindrance) {
    return hindrance == Hindrance::workLimit ? withLimitHint(reason, limitOf(arguments, scenario)) : reason;
}

Message couldNotBeSolved(const std::string& path, const Message& reason) {
    return {translatable("%1: could not be solved: %2"), {path, reason}};
}

OptionSpec workLimitSpec() {
    return {"work-limit", "N",
            "do not solve a blow whose waves the exact solver must split into more than N pieces (default: "
            "1000000, a few seconds at most)"};
}

std::vector<OptionSpec> rowOptionSpecs() {
    std::vector<OptionSpec> options = scenarioOptions(
        {{"outputs", "A,B|all",
          "outputs to write as columns, listed below (default: cor, the coefficient of restitution)"},
         {"si", "", "write outputs in SI, with units in the header"}});
    for (const OptionSpec& option : methodOptionSpecs()) options.push_back(option);
    for (const OptionSpec& option : std::initializer_list<OptionSpec>{
             {"work-limit", "N",
              "leave outputs empty if the exact solver must split the waves into more than N pieces "
              "(default: 1000000, at most about 2 s per row)"},
             {"j", "N", "number of threads (default: all)"},
             shardOptionSpec(),
             resumeOptionSpec(),
             {"o", "FILE.csv",
              "write the rows to FILE.csv, and the settings of the run to FILE.csv.yaml; -o - prints the "
              "rows (default)"},
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()})
        options.push_back(option);
    return options;
}

OptionSpec shardOptionSpec() {
    return {"shard", "I/N",
            "split the rows into N parts and solve only part I; `drillwave join` combines the parts; only "
            "part 1 has a header"};
}

OptionSpec resumeOptionSpec() {
    return {"resume", "",
            "keep completed rows in FILE.csv.partial; after an interruption, the same command continues "
            "after them"};
}

std::string outputHelp(const ReadingStyle& style) {
    std::string help = style.said(translatable("Outputs:"));
    std::size_t width = 0;
    for (const std::span<const Output> table : {outputs(), drillOutputs()})
        for (const Output& output : table) width = std::max(width, output.name.size());
    const auto add = [&](std::string_view name, std::string_view meaning) {
        help += "\n  " + std::string(name) + std::string(width - name.size() + 2, ' ') +
                style.patternFor(std::string(meaning));
    };
    for (const Output& output : outputs()) add(output.name, output.meaning);
    add("all", translatable("all of these that FILE has: some need a blow frequency, "
                            "thrust_margin a thrust too"));
    help += "\n" + style.said(translatable("Results of many blows, only by name (each takes a march); FILE "
                                           "needs drill.blow_frequency and drill.thrust:"));
    for (const Output& output : drillOutputs()) add(output.name, output.meaning);
    return help;
}

/// Parts are joined, and rows kept, with points and commas.
void checkDecimalComma(const Arguments& arguments) {
    if (!arguments.has("decimal-comma")) return;
    for (const char* option : {"shard", "resume"})
        if (arguments.has(option))
            throw CommandError(ExitCode::usage,
                               Message(translatable("%1 needs rows with points and commas; leave out "
                                                    "--decimal-comma"),
                                       {std::string("--") + option}));
}

RowOptions rowOptions(const Arguments& arguments, const std::optional<MethodChoice>& method) {
    checkDecimalComma(arguments);
    OutputChoice outputs = outputsOf(arguments);
    if (arguments.has("resume")) checkResumes(arguments);
    return {.columns = std::move(outputs.columns),
            .units = unitsOf(arguments),
            .allOutputs = outputs.all,
            .jobs = jobsOf(arguments),
            .shard = shardOf(arguments),
            .path = arguments.value("o").value_or("-"),
            .overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused,
            .resumes = arguments.has("resume"),
            .method = methodChoice(arguments, method),
            .workLimit = workLimitOf(arguments)};
}

int jobsOf(const Arguments& arguments) {
    return static_cast<int>(
        arguments.number("j", std::min(static_cast<long>(availableThreads()), maximumJobs), 1, maximumJobs));
}

std::vector<OutputColumn> RowOptions::columnsFor(const Scenario& scenario) const {
    return allOutputs ? allOutputsOf(scenario, units) : columns;
}

std::string commandText(std::string_view command, const Arguments& arguments) {
    return "drillwave " + std::string(command) + " " + arguments.shellText(aboutTheFile);
}

RowRecord recordOf(std::string_view command, const Arguments& arguments, const RowOptions& options,
                   std::span<const OutputColumn> columns, const ScenarioDocument& base, std::uint64_t rows) {
    RowRecord record{
        .command = commandText(command, arguments),
        .method = isFollowedByEvents(base.scenario) ? std::optional(options.method) : std::nullopt,
        .rows = rows,
        .shard = options.shard,
        .axes = {},
        .cases = {},
        .outputs = {},
        .scenario = completeScenarioText(base)};
    for (const OutputColumn& column : columns) record.outputs.push_back(column.header());
    return record;
}

void checkRows(const RowOptions& options, const Arguments& arguments, const ScenarioDocument& document) {
    const std::string record = recordName(options.path);
    for (const std::string& output : {options.path, record})
        checkOutputIsNoInput(output, arguments, document);
    if (options.resumes) return;  // the rows that are there are looked at when it is known what they must be
    checkOutput(options.path, options.overwrite);
    if (!isStream(options.path)) checkOverwrite(record, options.overwrite);
}

void commitRows(OutputFile& rows, const RowOptions& options, RowRecord record, std::vector<NamedFile> beside,
                const Interruption& interruption) {
    if (!isStream(options.path)) {
        const std::string name = std::filesystem::path(options.path).filename();
        record.file = rows.sum();
        rows.add({recordName(name), recordText(record)});
        for (NamedFile& file : beside) rows.add(std::move(file));
    }
    rows.commit(&interruption);
}

namespace {

/// Returns the part if FILE already has the rows of this record, for the report of a run in one piece.
std::optional<RowPart> rowsThere(const RowRecord& record, const std::string& path) {
    const FileBytes there = readFile(recordName(path), maximumInputBytes);
    std::ifstream rows(path, std::ios::binary);
    if (!there.problem.isEmpty() || !rows) return std::nullopt;
    try {
        RowPart part = parseRowPart(there.bytes, path);
        RowRecord same = record;
        same.unsolved = part.unsolved;
        same.file = sumOf(rows);
        return recordText(same) == there.bytes ? std::optional(std::move(part)) : std::nullopt;
    } catch (const ScenarioError&) {
        return std::nullopt;
    }
}

[[noreturn]] void refuseUnsolved(const RowCounts& counts, long workLimit) {
    if (counts.failures.empty())
        throw CommandError(ExitCode::unsolvedOrFailed, unsolvedRows(counts.failed, counts.rows));
    throw CommandError(ExitCode::unsolvedOrFailed,
                       Message("%1; %2", {unsolvedRows(counts.failed, counts.rows),
                                          reasonsOf(counts, RowNoun::row, workLimit)}));
}

/// "1.6 MB", "40 TB".
std::string bytesText(double bytes, const ReadingStyle& style) {
    constexpr const char* units[] = {"bytes", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (; bytes >= 1000 && unit + 1 < std::size(units); ++unit) bytes /= 1000;
    return style.number(bytes, 2) + " " + units[unit];
}

/// Reports once, as soon as the rate is known, how long many rows will take, and refuses rows for which the
/// disk has no room.
class RowForecast {
  public:
    RowForecast(const RowOptions& options, const RowsDone& begin, std::uint64_t rows,
                const ReadingStyle& style)
        : m_options(options), m_begin(begin), m_rows(rows), m_style(style) {}

    /// Throws CommandError (unwritable output).
    void show(std::uint64_t rows, std::uint64_t bytes) {
        const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
        if (m_isDone || seconds < 1 || rows <= m_begin.rows) return;
        m_isDone = true;
        const double done = static_cast<double>(rows - m_begin.rows);
        const double left = static_cast<double>(m_rows - rows);
        const double bytesLeft = static_cast<double>(bytes - m_begin.sum.bytes) / done * left;
        const double all = static_cast<double>(bytes) + bytesLeft;
        if (!isStream(m_options.path)) checkRoom(all, bytesLeft);
        if (seconds / done * left < worthTelling) return;
        printRemark({translatable("%1 rows take about %2 and %3. An interrupted run keeps no rows; with "
                                  "--resume it keeps finished rows, with --shard I/N finished parts"),
                     {std::to_string(m_rows), bytesText(all, m_style), durationText(seconds / done * left)}},
                    m_style);
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr double worthTelling = 600;  // [s]

    void checkRoom(double all, double needed) const {
        std::error_code error;
        const std::filesystem::path folder = std::filesystem::path(m_options.path).parent_path();
        const auto space = std::filesystem::space(folder.empty() ? "." : folder, error);
        if (error || needed <= static_cast<double>(space.available)) return;
        throw CommandError(
            ExitCode::unwritableOutput,
            Message(translatable("%1: %2 rows take about %3, and the disk has %4 free; take fewer rows, or "
                                 "write parts (--shard I/N) to several disks"),
                    {m_options.path, std::to_string(m_rows), bytesText(all, m_style),
                     bytesText(static_cast<double>(space.available), m_style)}));
    }

    const RowOptions& m_options;
    RowsDone m_begin;
    std::uint64_t m_rows;
    const ReadingStyle& m_style;
    Clock::time_point m_start = Clock::now();
    bool m_isDone = false;
};

/// Opens the rows of an earlier run, which this one continues. Throws CommandError.
std::unique_ptr<KeptRows> keptRows(const RowRecord& record, const RowOptions& options) {
    if (!options.resumes) return nullptr;
    checkOutput(options.path, options.overwrite);
    auto kept = std::make_unique<KeptRows>(
        options.path, recordEntries(record),
        options.overwrite == Overwrite::allowed ? KeptRows::Other::isReplaced : KeptRows::Other::isProblem);
    if (!kept->problem().isEmpty()) throw CommandError(ExitCode::unwritableOutput, kept->problem());
    return kept;
}

/// Throws CommandError: unwritable output.
void note(KeptRows* kept, const RowsDone& done, WriteFailure (KeptRows::*how)(const RowsDone&)) {
    if (!kept) return;
    if (const WriteFailure failure = (kept->*how)(done))
        throw CommandError(ExitCode::unwritableOutput, notWritten(recordName(kept->path()), failure));
}

}  // namespace

Message unsolvedRows(std::uint64_t unsolved, std::uint64_t rows) {
    return {translatable("%1 of %2 rows could not be solved: their output cells are empty"),
            {std::to_string(unsolved), std::to_string(rows)}};
}

ExitCode writeRows(const RunRows& run, const RowRecord& record, const RowOptions& options,
                   const Interruption& interruption, const ReadingStyle& style, const DrawRows& draw) {
    if (options.resumes)
        if (const std::optional<RowPart> there = rowsThere(record, options.path)) {
            printRemark({translatable("%1: has all of these rows already"), {options.path}}, style);
            if (there->unsolved == 0) return ExitCode::done;
            throw CommandError(ExitCode::unsolvedOrFailed, unsolvedRows(there->unsolved, there->rows));
        }
    const std::unique_ptr<KeptRows> kept = keptRows(record, options);
    const RowsDone begin = kept ? kept->done() : RowsDone();
    RowsDone done = begin;
    RowCounts counts;
    {
        OutputFile out = kept ? OutputFile(options.path, options.overwrite, *kept)
                              : OutputFile(options.path, options.overwrite);
        ProgressBar bar(record.rows, translatable("rows"), style);
        RowForecast forecast(options, begin, record.rows, style);
        RowCsv csv([&](std::string_view text) {
            out.write(text);
            return true;
        });
        counts = run(
            interruption.token(), csv,
            [&](const RowCounts& soFar) {
                done = {begin.rows + soFar.rows, begin.unsolved + soFar.failed, out.sum()};
                note(kept.get(), done, &KeptRows::note);
                forecast.show(done.rows, done.sum.bytes);
                bar.show(done.rows);
            },
            begin.rows);
        counts.rows = done.rows;
        counts.failed = done.unsolved;
        if (counts.end == WorkEnd::stopped && kept) {
            note(kept.get(), done, &KeptRows::noteNow);
            throw CommandError(
                ExitCode::interrupted,
                Message(
                    translatable(
                        "interrupted; %1 of %2 rows are kept in %3; the same command continues after them"),
                    {std::to_string(done.rows), std::to_string(record.rows), kept->path()}));
        }
        if (counts.end == WorkEnd::stopped) interruption.check();
        RowRecord whole = record;
        whole.unsolved = counts.failed;
        commitRows(out, options, std::move(whole), draw ? draw() : std::vector<NamedFile>(), interruption);
    }
    if (kept) kept->remove();
    if (counts.failed > 0) refuseUnsolved(counts, options.workLimit);
    return ExitCode::done;
}

}  // namespace drillwave
