// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/row_options.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "app/method_options.h"
#include "app/progress_bar.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/model/blow_traits.h"
#include "core/text/decimal_text.h"
#include "core/text/message_list.h"

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

/// What changes where the rows go and how fast, not what they are.
constexpr std::string_view aboutTheFile[] = {"o", "force", "j", "plots", "gaps"};

Shard shardOf(const Arguments& arguments) {
    const std::string text = arguments.value("shard").value_or("1/1");
    const std::optional<Shard> shard = parseShard(text);
    if (!shard)
        throw CommandError(ExitCode::usage, Message(translatable("drillwave::Message",
                                                                 "--shard %1: needs I/N, 1 <= I <= N <= %2"),
                                                    {shortened(text), std::to_string(maximumShards)}));
    return *shard;
}

int allThreads() {
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 1024U));
}

Message withLimitHint(const Message& reason, long workLimit) {
    return {translatable("drillwave::Message", "%1; --work-limit, now %2, permits more"),
            {reason, std::to_string(workLimit)}};
}

/// Of a blow within workLimitsOf().
long limitOf(const Arguments& arguments, const Scenario& scenario) {
    const long ofString = WorkLimits().cells / cellsOfPiece;
    return workLimitOf(arguments, isFollowedByEvents(scenario) ? defaultWorkLimit : ofString);
}

/// "2 rows", to stand before a reason.
Message countOf(std::uint64_t count, RowNoun noun) {
    if (noun == RowNoun::row)
        return counted(count, translatable("drillwave::Message", "%1 row"),
                       translatable("drillwave::Message", "%1 rows"));
    return counted(count, translatable("drillwave::Message", "%1 point"),
                   translatable("drillwave::Message", "%1 points"));
}

}  // namespace

Message reasonsOf(const RowCounts& counts, RowNoun noun, long workLimit) {
    Message text;
    std::uint64_t told = 0;
    bool atLimit = false;
    for (const RowFailure& failure : counts.failures) {
        text = joined(std::move(text), "%1; %2", about(countOf(failure.rows, noun), failure.reason));
        told += failure.rows;
        atLimit |= isAtLimit(failure.reason);
    }
    if (told < counts.failed)
        text = {translatable("drillwave::Message", "%1; %2 for other reasons"),
                {text, std::to_string(counts.failed - told)}};
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

bool isAtLimit(const Message& reason) {
    const std::string text = reason.text();
    return text.find("wave pieces") != std::string::npos || text.find("wave cells") != std::string::npos;
}

Message reasonWithHint(const Message& reason, long workLimit) {
    return isAtLimit(reason) ? withLimitHint(reason, workLimit) : reason;
}

Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario) {
    return reasonWithHint(reason, limitOf(arguments, scenario));
}

Message reasonWithHint(const Message& reason, const Arguments& arguments, const Scenario& scenario,
                       Hindrance hindrance) {
    return hindrance == Hindrance::workLimit ? withLimitHint(reason, limitOf(arguments, scenario)) : reason;
}

Message couldNotBeSolved(const std::string& path, const Message& reason) {
    return {translatable("drillwave::Message", "%1: could not be solved: %2"), {path, reason}};
}

OptionSpec workLimitSpec() {
    return {"work-limit", "N", "wave pieces a blow may take, 1000000 (at worst some seconds) if not given"};
}

std::vector<OptionSpec> rowOptionSpecs() {
    std::vector<OptionSpec> options =
        scenarioOptions({{"outputs", "A,B|all", "output columns, cor if not given; see below"},
                         {"si", "", "outputs in SI, with units in the header"}});
    for (const OptionSpec& option : methodOptionSpecs()) options.push_back(option);
    for (const OptionSpec& option : std::initializer_list<OptionSpec>{
             {"work-limit", "N",
              "wave pieces a row may take, 1000000 (at worst 2 s) if not given; else its cells are empty"},
             {"j", "N", "threads to use, all of them if not given"},
             shardOptionSpec(),
             {"o", "FILE.csv",
              "where to write, with FILE.csv.yaml beside it; - is standard output, as without"},
             {"force", "", "overwrite existing files"}})
        options.push_back(option);
    return options;
}

OptionSpec shardOptionSpec() {
    return {"shard", "I/N",
            "only the I-th of N contiguous parts, for `drillwave join`; header only in part 1"};
}

std::string outputHelp(const ReadingStyle& style) {
    std::string help = style.said(translatable("drillwave::Message", "Outputs:"));
    std::size_t width = 0;
    for (const std::span<const Output> table : {outputs(), drillOutputs()})
        for (const Output& output : table) width = std::max(width, output.name.size());
    const auto add = [&](std::string_view name, std::string_view meaning) {
        help += "\n  " + std::string(name) + std::string(width - name.size() + 2, ' ') +
                style.patternFor(std::string(meaning));
    };
    for (const Output& output : outputs()) add(output.name, output.meaning);
    add("all", translatable("drillwave::Message",
                            "all of these that FILE has: some need a blow frequency, "
                            "thrust_margin a thrust too"));
    help +=
        "\n" + style.said(translatable(
                   "drillwave::Message",
                   "Of many blows, by name alone, as they take a march each; FILE needs drill.blow_frequency "
                   "and drill.thrust:"));
    for (const Output& output : drillOutputs()) add(output.name, output.meaning);
    return help;
}

RowOptions rowOptions(const Arguments& arguments, const std::optional<MethodChoice>& method) {
    OutputChoice outputs = outputsOf(arguments);
    return {.columns = std::move(outputs.columns),
            .units = unitsOf(arguments),
            .allOutputs = outputs.all,
            .jobs = jobsOf(arguments),
            .shard = shardOf(arguments),
            .path = arguments.value("o").value_or("-"),
            .overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused,
            .method = methodChoice(arguments, method),
            .workLimit = workLimitOf(arguments)};
}

int jobsOf(const Arguments& arguments) {
    return static_cast<int>(arguments.number("j", allThreads(), 1, maximumJobs));
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

void checkRows(const RowOptions& options, const std::string& input, const ScenarioDocument& document,
               const std::vector<std::string>& otherInputs) {
    checkOutputIsNoInput(options.path, input, document, otherInputs);
    checkOutput(options.path, options.overwrite);
    if (isStream(options.path)) return;
    const std::string record = recordName(options.path);
    checkOutputIsNoInput(record, input, document, otherInputs);
    checkOverwrite(record, options.overwrite);
}

void commitRows(OutputFile& rows, const RowOptions& options, const RowRecord& record,
                std::vector<NamedFile> beside, const Interruption& interruption) {
    if (!isStream(options.path)) {
        const std::string name = std::filesystem::path(options.path).filename();
        rows.add({recordName(name), recordText(record)});
        for (NamedFile& file : beside) rows.add(std::move(file));
    }
    rows.commit(&interruption);
}

ExitCode writeRows(const RunRows& run, const RowRecord& record, const RowOptions& options, OutputFile& out,
                   const Interruption& interruption, const ReadingStyle& style, const DrawRows& draw) {
    RowCounts counts;
    {
        ProgressBar bar(record.rows, translatable("drillwave::Message", "rows"), style);
        RowCsv csv([&](std::string_view text) {
            out.write(text);
            return true;
        });
        counts = run(interruption.token(), csv, [&](const RowCounts& soFar) { bar.show(soFar.rows); });
    }
    if (counts.end == WorkEnd::stopped) interruption.check();
    commitRows(out, options, record, draw ? draw() : std::vector<NamedFile>(), interruption);
    if (counts.failed == 0) return ExitCode::done;
    throw CommandError(
        ExitCode::unsolvedOrFailed,
        Message(translatable("drillwave::Message",
                             "%1 of %2 rows could not be solved: their output cells are empty; %3"),
                {std::to_string(counts.failed), std::to_string(counts.rows),
                 reasonsOf(counts, RowNoun::row, options.workLimit)}));
}

}  // namespace drillwave
