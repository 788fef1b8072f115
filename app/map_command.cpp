// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave map FILE --x KEY=… --y KEY=…
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/method_options.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/numeric/run_time.h"
#include "core/report/map_report.h"
#include "core/study/map/map_rows.h"
#include "core/study/rows/sweep.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

SweepAxis axisOf(const Arguments& arguments, const std::string& option) {
    const std::optional<std::string> word = arguments.value(option);
    if (!word)
        throw CommandError(
            ExitCode::usage,
            Message(
                translatable(
                    "needs --x KEY=START:STOP:COUNT[:log] and --y KEY=START:STOP:COUNT[:log]; %1 is missing"),
                {"--" + option}));
    // A map lies between even steps: axisArgument() would take a list, and name it where it takes none.
    const auto colons = std::ranges::count(*word, ':');
    if (colons < 2 || colons > 3)
        throw CommandError(ExitCode::usage,
                           about(quotedAxis(option, *word),
                                 translatable("a map needs KEY=START:STOP:COUNT or KEY=START:STOP:COUNT:log; "
                                              "`drillwave sweep` takes a list")));
    return axisArgument(option, *word);
}

OutputColumn outputOf(const Arguments& arguments, OutputUnits units) {
    const OutputChoice choice = chooseOutputs(arguments.value("output").value_or("cor"), units);
    if (!choice.problem.isEmpty()) throw CommandError(ExitCode::usage, about("--output", choice.problem));
    if (choice.columns.size() != 1)
        throw CommandError(
            ExitCode::usage,
            translatable("--output: a map has one output; for several take `drillwave sweep`"));
    return choice.columns.front();
}

std::vector<double> levelsOf(const Arguments& arguments, const OutputColumn& output) {
    return levelArguments(arguments, output.quantity());
}

/// The files of -o.
struct MapFiles {
    RowOptions rows;
    std::string contours;  ///< empty where there are none
};

/// Finds out before anything is computed whether they can be written.
MapFiles filesOf(const Arguments& arguments, const RowOptions& options, const ScenarioDocument& document) {
    MapFiles files{options, {}};
    const bool hasFile = arguments.has("o") && !isStream(options.path);
    if (arguments.has("force") && (!arguments.has("o") || options.path == "-"))
        throw CommandError(ExitCode::usage,
                           translatable("--force applies to the file of -o; add -o FILE.csv"));
    if (isStream(options.path) && arguments.has("o"))
        for (const char* option : {"level", "json"})
            if (arguments.has(option))
                throw CommandError(
                    ExitCode::usage,
                    Message(
                        translatable("%1 cannot be used with -o -, which prints the map; give -o FILE.csv"),
                        {std::string("--") + option}));
    if (!hasFile) return files;
    checkRows(options, arguments, document);
    if (!arguments.has("level")) return files;
    files.contours = contoursName(options.path);
    checkOutputIsNoInput(files.contours, arguments, document);
    checkOverwrite(files.contours, options.overwrite);
    return files;
}

MapReport solve(const MapStudy& study, const std::vector<double>& levels, int jobs, const ReadingStyle& style,
                const Interruption& interruption) {
    const Stopwatch watch;
    MapReport report{.study = study, .grid = {}, .contours = {}, .runTime = 0, .scenarioText = {}};
    {
        ProgressBar bar(study.x.count * study.y.count, translatable("points"), style);
        report.grid = solveMap(study, jobs, interruption.token(),
                               [&](const MapGrid& soFar) { bar.show(soFar.done()); });
    }
    interruption.check();
    for (const double level : levels) {
        std::optional<ProgressBar> bar;
        report.contours.push_back(contourOf(study, report.grid, level, jobs, interruption.token(),
                                            [&](std::uint64_t placed, std::uint64_t crossings) {
                                                if (!bar)
                                                    bar.emplace(crossings, translatable("contour points"),
                                                                style);
                                                bar->show(placed);
                                            }));
        interruption.check();
    }
    report.runTime = watch.seconds();
    return report;
}

void writeFiles(const MapFiles& files, const MapReport& report, RowRecord record,
                std::vector<NamedFile> beside, const Interruption& interruption) {
    OutputFile rows(files.rows.path, files.rows.overwrite);
    RowCsv csv([&](std::string_view text) {
        rows.write(text);
        return true;
    });
    giveRows(report.study, report.grid, csv);
    if (!files.contours.empty())
        beside.push_back({std::filesystem::path(files.contours).filename(), contoursCsv(report)});
    record.unsolved = report.grid.failed();
    commitRows(rows, files.rows, std::move(record), std::move(beside), interruption);
}

/// Done, or why not all of it is.
ExitCode judge(const MapReport& report, long workLimit) {
    const RowCounts counts{
        .rows = report.grid.size(), .failed = report.grid.failed(), .failures = report.grid.failures()};
    for (const Contour& contour : report.contours)
        if (counts.failed == 0 && contour.unplaced > 0)
            throw CommandError(ExitCode::unsolvedOrFailed,
                               Message(translatable("%1 points of a contour could not be placed: %2"),
                                       {std::to_string(contour.unplaced), contour.reason}));
    if (counts.failed == 0) return ExitCode::done;
    throw CommandError(ExitCode::unsolvedOrFailed,
                       Message(translatable("%1 of %2 points could not be solved and have no output; %3"),
                               {std::to_string(counts.failed), std::to_string(counts.rows),
                                reasonsOf(counts, RowNoun::point, workLimit)}));
}

/// Checks that a part of a map writes only rows.
void checkPart(const Arguments& arguments) {
    if (!arguments.has("shard")) return;
    if (!arguments.has("o"))
        throw CommandError(ExitCode::usage,
                           translatable("--shard: a part of a map has only rows; add -o FILE.csv"));
    for (const char* option : {"level", "json", "plots"})
        if (arguments.has(option))
            throw CommandError(ExitCode::usage,
                               Message(translatable("%1 needs the map in one piece; leave out --shard"),
                                       {std::string("--") + option}));
}

ExitCode writePart(const MapStudy& study, const RowRecord& record, const RowOptions& options,
                   const ReadingStyle& style, const Interruption& interruption) {
    Sweep rows{.base = study.base,
               .axes = {study.x, study.y},
               .columns = {study.output},
               .shard = options.shard,
               .method = study.method,
               .workLimit = study.workLimit};
    const auto run = [&](std::stop_token stop, RowSink& sink, const RowProgress& progress,
                         std::uint64_t done) {
        rows.done = done;
        return runSweep(rows, options.jobs, stop, sink, progress);
    };
    return writeRows(run, record, options, interruption, style);
}

ExitCode runMap(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    checkPart(arguments);
    const SweepAxis x = axisOf(arguments, "x"), y = axisOf(arguments, "y");
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const ScenarioInput input = loadScenarioInput(path, arguments);
    const ScenarioDocument& base = input.document;
    checkNotSet(arguments, base.scenario, std::array{x, y},
                std::array{quotedAxis("x", *arguments.value("x")), quotedAxis("y", *arguments.value("y"))});
    const RowOptions options = rowOptions(arguments, input.method);
    checkMethodOfString(options.method, input.document.scenario, path);
    const MapStudy study{.base = base.scenario,
                         .x = x,
                         .y = y,
                         .output = outputOf(arguments, options.units),
                         .method = options.method,
                         .workLimit = options.workLimit};
    const std::vector<double> levels = levelsOf(arguments, study.output);
    if (std::vector<Message> problems = problemsOf(study); !problems.empty())
        throw CommandError(ExitCode::invalidScenario, eachAbout(path, std::move(problems)));
    const MapFiles files = filesOf(arguments, options, base);
    if (!arguments.has("o") || options.path != "-") checkStandardOutput();
    plots.check(arguments, base, options.overwrite);
    RowRecord record = recordOf("map", arguments, options, {&study.output, 1}, base,
                                rowsOf(options.shard, x.count * y.count).size());
    for (const auto& [axis, option] : {std::pair{&x, "x"}, {&y, "y"}})
        record.axes.push_back(recordedAxis(*axis, *arguments.value(option)));

    const Interruption interruption;
    remarkOnValues(base.scenario, path, arguments.style());
    if (arguments.has("shard") || options.resumes)
        return writePart(study, record, options, arguments.style(), interruption);
    MapReport report = solve(study, levels, options.jobs, arguments.style(), interruption);
    report.scenarioText = record.scenario;
    if (arguments.has("o"))
        writeFiles(files, report, record, plots.draw(&report, drawing, interruption), interruption);
    if (!arguments.has("o") || options.path != "-")
        printText(arguments.has("json") ? mapJson(report) : mapText(report, arguments.style()));
    return judge(report, options.workLimit);
}

std::vector<OptionSpec> mapOptions() {
    std::vector<OptionSpec> options = scenarioOptions(
        {{"x", "KEY=VALUES",
          "vary this parameter on the horizontal axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log "
          "(equal ratios)"},
         {"y", "KEY=VALUES",
          "vary this parameter on the vertical axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log "
          "(equal ratios)"},
         {"output", "A", "output to map, listed below (default: cor, the coefficient of restitution)"},
         {"level", "X", "find the contour on which the output has this value; may be repeated",
          OptionSpec::Times::repeated},
         {"si", "", "use SI units for the output and for the value of --level, which may then carry a unit"},
         {"json", "", "print the summary and the contours of the map as one JSON object"}});
    for (const OptionSpec& option : methodOptionSpecs()) options.push_back(option);
    for (const OptionSpec& option : std::initializer_list<OptionSpec>{
             {"work-limit", "N",
              "skip points for which the exact solver must split the waves into more than N pieces (default: "
              "1000000, at most about 2 s per point)"},
             {"j", "N", "number of threads (default: all)"},
             shardOptionSpec(),
             resumeOptionSpec(),
             {"o", "FILE.csv",
              "also write the map to FILE.csv, its settings to FILE.csv.yaml and its contours to "
              "FILE_contours.csv; -o - prints the points instead of the summary"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()})
        options.push_back(option);
    return options;
}

}  // namespace

const Command& mapCommand() {
    static constexpr std::string_view details =
        "Solves the output at every point of a grid of two parameters. FILE.csv has one row for each point,\n"
        "with the same columns as from `drillwave sweep`; --y varies fastest. With --level X, also finds\n"
        "the contour on which the output is X. Each point of a contour lies between two neighbouring grid\n"
        "points and is solved for, not interpolated. FILE_contours.csv lists these points, how near to X\n"
        "each one is, and where the output jumps over X.";
    static const Command command{
        .name = "map",
        .operands = "FILE",
        .summary = "map one output over two parameters, with contours",
        .details = details,
        .furtherHelp = outputHelp,
        .options = mapOptions(),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runMap,
    };
    return command;
}

}  // namespace drillwave
