// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave drill FILE
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/input_text.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/archive/result_scenario.h"
#include "core/archive/study_files.h"
#include "core/model/parameter_text.h"
#include "core/report/drilling_report.h"
#include "core/report/drilling_scan_report.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

const std::vector<std::string> drillFiles{"scenario.yaml", "summary.json", "blows.csv", "histories.csv"};

/// Cells times nodes that a march may take unless --work-limit permits more, and about how many a second has.
constexpr double mostWork = 4e9, workOfSecond = 2e7;

OutputUnits outputUnits(const Arguments& arguments) {
    if (arguments.has("si") && arguments.has("dimensionless"))
        throw CommandError(ExitCode::usage, "--si and --dimensionless exclude each other");
    return arguments.has("dimensionless") ? OutputUnits::dimensionless : OutputUnits::si;
}

int cellsOf(const Arguments& arguments, int usual) {
    const std::optional<std::string> text = arguments.value("cells");
    if (!text) return usual;
    const std::optional<int> cells = wholeNumberIn<int>(*text);
    if (!cells || *cells < leastDrillingCells || *cells > mostDrillingCells)
        throw CommandError(ExitCode::usage, "--cells " + shortened(*text) + " " +
                                                wholeNumberProblem(leastDrillingCells, mostDrillingCells));
    return *cells;
}

/// --blows and so on are short for --set drill.…
void setShort(const Arguments& arguments, Scenario& scenario) {
    for (const char* option : {"blows", "settle", "seed"}) {
        const std::optional<std::string> text = arguments.value(option);
        if (!text) continue;
        const std::string problem = assignText(scenario, "drill." + std::string(option), *text);
        if (!problem.empty())
            throw CommandError(ExitCode::usage, "--" + std::string(option) + ": " + problem);
    }
}

/// --histories A:B.
std::optional<BlowRange> historiesOf(const Arguments& arguments, const std::optional<std::string>& out,
                                     const DrillingSettings& settings) {
    const std::optional<std::string> text = arguments.value("histories");
    if (!text) return std::nullopt;
    const auto wrong = [&](const std::string& reason) {
        throw CommandError(ExitCode::usage, "--histories " + shortened(*text) + " " + reason);
    };
    if (!out || *out == "-" || out->ends_with(".csv")) wrong("needs a folder: add -o DIR");
    const std::size_t colon = text->find(':');
    const std::optional<long> first = wholeNumberIn<long>(text->substr(0, colon));
    const std::optional<long> last =
        colon == std::string::npos ? first : wholeNumberIn<long>(text->substr(colon + 1));
    if (!first || !last || *first < 1 || *last < *first || *last > settings.blows)
        wrong("must be A:B, blows from 1 to " + std::to_string(settings.blows));
    return BlowRange{*first, *last};
}

void refuse(const std::vector<std::string>& problems, const std::string& path) {
    if (problems.empty()) return;
    std::vector<std::string> lines;
    for (const std::string& problem : problems) lines.push_back(inputName(path) + ": " + problem);
    throw CommandError(ExitCode::invalidScenario, std::move(lines));
}

double permittedWork(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("work-limit");
    if (!text) return mostWork;
    const std::optional<double> work = parseNumber(*text);
    if (!work || !(*work >= 1))
        throw CommandError(ExitCode::usage,
                           "--work-limit " + shortened(*text) + " must be a number of at least 1");
    return *work;
}

void checkWork(double work, const Arguments& arguments) {
    const double permitted = permittedWork(arguments);
    if (work <= permitted) return;
    throw CommandError(ExitCode::unsolvedOrFailed,
                       "it takes " + rounded(work, 3) + " cells times nodes, more than the " +
                           rounded(permitted, 3) + " permitted, about " +
                           inHandyUnit(work / workOfSecond, Quantity::time, 2) +
                           "; fewer blows or --cells take less, --work-limit permits more");
}

void printRemark(const std::string& text) {
    std::fprintf(stderr, "%s\n", printable(text).c_str());
}

void remarkOnUnused(const Scenario& scenario, const std::string& path) {
    const Drill& drill = scenario.drill;
    if (isString(scenario) && scenario.drillString.endTime)
        printRemark(inputName(path) + ": end_time counts for single blows, not here");
    if (drill.machineMass.value_or(0) > 0 && drill.damperDamping.value_or(0) == 0 &&
        drill.damperStiffness.value_or(0) == 0)
        printRemark(inputName(path) +
                    ": machine_mass without a damper: the machine presses with a constant force");
}

/// Finds out before anything is computed whether a file of rows can be written, with a record beside it.
void checkRowFile(const std::string& file, const std::string& path, const ScenarioDocument& document,
                  Overwrite overwrite) {
    checkOutputIsNoInput(file, path, document);
    checkOutput(file, overwrite);
    if (isStream(file)) return;
    checkOutputIsNoInput(recordName(file), path, document);
    checkOverwrite(recordName(file), overwrite);
}

/// What the rows are and how to get them.
NamedFile recordBeside(const std::string& file, const RowRecord& record) {
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

/// The table of a scan and its gaps: one set where they are in one folder.
void writeScan(const DrillingScanReport& report, const Arguments& arguments, OutputUnits units,
               const Interruption& interruption) {
    namespace fs = std::filesystem;
    const std::optional<std::string> out = arguments.value("o"), gaps = arguments.value("gaps");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const bool isFile = out && !isStream(*out);
    std::vector<NamedFile> beside;
    if (isFile) {
        RowRecord record = drillRecord(arguments, report.scenarioText, report.scan.points.size());
        record.axes.push_back(recordedAxis(report.scan.axis, *arguments.value("scan")));
        for (const OutputColumn& column : drillingScanColumns(units))
            record.outputs.push_back(column.header());
        beside.push_back(recordBeside(*out, record));
    }
    const bool isOneSet =
        isFile && gaps && !isStream(*gaps) && fs::path(*out).parent_path() == fs::path(*gaps).parent_path();
    if (isOneSet)
        beside.push_back({fs::path(*gaps).filename().string(), drillingGapsCsv(report, units)});
    else if (gaps)
        writeStudy(*gaps, drillingGapsCsv(report, units), {}, overwrite, interruption);
    if (out) writeStudy(*out, drillingScanCsv(report, units), std::move(beside), overwrite, interruption);
}

/// Throws where values have no answer.
void checkAnswers(const DrillingScan& scan, const std::string& path) {
    std::size_t failed = 0;
    std::string reason;
    for (const DrillingScanPoint& point : scan.points) {
        if (point.result.outcome != DrillingOutcome::notSolved) continue;
        if (failed++ == 0) reason = point.result.reason;
    }
    if (failed == 0) return;
    throw CommandError(ExitCode::unsolvedOrFailed,
                       path + ": " + std::to_string(failed) + " of " + std::to_string(scan.points.size()) +
                           " rows could not be solved: their cells are empty; the first: " + reason);
}

ExitCode scan(const Arguments& arguments, const ScenarioDocument& document, const std::string& path) {
    const OutputUnits units = outputUnits(arguments);
    const std::string word = *arguments.value("scan");
    const ParsedAxis parsed = parseAxis(word);
    if (!parsed.problem.empty()) throw CommandError(ExitCode::usage, "--scan: " + parsed.problem);
    const SweepAxis& axis = parsed.axis;
    checkNotSet(arguments, document.scenario, std::span(&axis, 1), std::vector{quotedAxis("scan", word)});
    DrillingSettings settings = scanSettingsOf(document.scenario);
    settings.cells = cellsOf(arguments, scanCells);
    refuse(scanRefusals(document.scenario, axis, settings), path);
    Scenario first = document.scenario;
    (void)axis.assign(first, axis.value(0));
    checkWork(static_cast<double>(axis.count) * scanWork(first, settings), arguments);
    const std::optional<std::string> out = arguments.value("o"), gaps = arguments.value("gaps");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    for (const std::optional<std::string>& file : {out, gaps})
        if (file && *file != "-") checkRowFile(*file, path, document, overwrite);
    if (out && gaps && *out == *gaps)
        throw CommandError(ExitCode::usage, "-o and --gaps name one file; give two");
    const int jobs = jobsOf(arguments);
    checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path);
    remarkOnUnused(document.scenario, path);
    ProgressBar bar(axis.count, "values");
    std::uint64_t done = 0;
    DrillingScanReport report{
        .scan = scanDrilling(
            document.scenario, axis, settings,
            {.jobs = jobs,
             .lyapunov = true,
             .stop = interruption.token(),
             .progress = [&](long more) { bar.show(done += static_cast<std::uint64_t>(more)); }}),
        .scenarioText = completeScenarioText(document)};
    interruption.check();
    writeScan(report, arguments, units, interruption);
    if (out != "-")
        printText(arguments.has("json") ? drillingScanJson(report, units) : drillingScanText(report, units));
    checkAnswers(report.scan, path);
    return ExitCode::done;
}

bool isFolder(const std::string& out) {
    return out != "-" && !out.ends_with(".csv");
}

std::vector<NamedFile> filesOf(const DrillingReport& report, OutputUnits units) {
    std::vector<NamedFile> files{{"scenario.yaml", report.scenarioText},
                                 {"summary.json", drillingJson(report, units)},
                                 {"blows.csv", drillingCsv(report, units)}};
    if (!report.result.instants.empty())
        files.push_back({"histories.csv", drillingHistoriesCsv(report, units)});
    return files;
}

/// The row of every blow.
void writeBlows(const DrillingReport& report, const Arguments& arguments, OutputUnits units,
                const Interruption& interruption) {
    const std::string out = *arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    std::vector<NamedFile> beside;
    if (!isStream(out)) {
        RowRecord record = drillRecord(arguments, report.scenarioText, report.result.blows.size());
        record.outputs = drillingHeaders(report.result, units);
        beside.push_back(recordBeside(out, record));
    }
    writeStudy(out, drillingCsv(report, units), std::move(beside), overwrite, interruption);
}

ExitCode runDrill(const Arguments& arguments, const Drawing*) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> out = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    if (arguments.has("force") && !out)
        throw CommandError(ExitCode::usage, "--force is about the files of -o; add -o FILE.csv or -o DIR");
    if (out == "-" && arguments.has("json"))
        throw CommandError(ExitCode::usage, "--json and -o - would both print to standard output; take one");
    if (arguments.has("gaps") && !arguments.has("scan"))
        throw CommandError(ExitCode::usage, "--gaps is about a scan; add --scan KEY=START:STOP:COUNT");
    ScenarioDocument document = loadScenarioArgument(path, arguments);
    setShort(arguments, document.scenario);
    if (arguments.has("scan")) return scan(arguments, document, path);

    const OutputUnits units = outputUnits(arguments);
    DrillingSettings settings = drillingSettingsOf(document.scenario);
    settings.cells = cellsOf(arguments, settings.cells);
    refuse(drillingRefusals(document.scenario, settings), path);
    DrillingWants wants;
    wants.histories = historiesOf(arguments, out, settings);
    if (wants.histories && foreseenInstants(document.scenario, settings, *wants.histories) >
                               static_cast<double>(mostDrillingInstants))
        throw CommandError(ExitCode::usage, "--histories: these blows have more than " +
                                                std::to_string(mostDrillingInstants) +
                                                " samples; take fewer blows or fewer --cells");
    wants.jobs = jobsOf(arguments);
    checkWork(drillingWork(document.scenario, settings, wants), arguments);
    if (out && *out != "-" && !isFolder(*out)) {
        checkRowFile(*out, path, document, overwrite);
    } else if (out && isFolder(*out)) {
        for (const std::string& name : drillFiles) checkOutputIsNoInput(*out + "/" + name, path, document);
        checkFolder(*out, drillFiles, overwrite);
    }
    if (out != "-") checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path);
    remarkOnUnused(document.scenario, path);
    ProgressBar bar(static_cast<std::uint64_t>(foreseenBlows(settings, wants)), "blows");
    std::uint64_t done = 0;
    DrillingReport report{
        .result = studyDrilling(document.scenario, settings, wants, interruption.token(),
                                [&](long more) { bar.show(done += static_cast<std::uint64_t>(more)); }),
        .scenarioText = completeScenarioText(document)};
    interruption.check();
    if (report.result.outcome == DrillingOutcome::notSolved)
        throw CommandError(ExitCode::unsolvedOrFailed,
                           path + ": could not be solved: " + report.result.reason);
    if (out && isFolder(*out))
        writeFolder(
            *out,
            {.files = filesOf(report, units),
             .outdated = [](const std::string& there) { return studyFilesThere(there, "drilling.csv"); }},
            overwrite, &interruption);
    else if (out)
        writeBlows(report, arguments, units, interruption);
    if (out != "-")
        printText(arguments.has("json") ? drillingJson(report, units) : drillingText(report, units));
    return ExitCode::done;
}

}  // namespace

const Command& drillCommand() {
    static const Command command{
        .name = "drill",
        .operands = "FILE",
        .summary = "many blows under a feed: gaps, penetration, whether the bit stays on the rock",
        .details =
            "Follows blow after blow: waves, motions and the machine on its damper live on between them, "
            "the\n"
            "rock is new for every blow. Told are the means with their errors, how many blows begin on the\n"
            "rock, whether the motion repeats, where the energy goes, and in a sentence what the thrust is "
            "good\n"
            "for with this damper. FILE needs drill.blow_frequency and drill.thrust. Penetrations are upper\n"
            "limits. With --scan the same over a parameter, each value from rest and from bouncing.",
        .options = scenarioOptions(
            {{"blows", "N", "short for --set drill.blows=N; 1000, of a scan 300, if not given"},
             {"settle", "N", "short for --set drill.settle=N: the first blows, which no statistic counts"},
             {"seed", "N", "short for --set drill.seed=N, of the scatter of the intervals"},
             {"cells", "N", "cells of time per t0, 10 to 400; 40, of a scan 20, if not given"},
             {"scan", "KEY=START:STOP:COUNT", "over these values; :log behind it, or KEY=A,B,C"},
             {"gaps", "FILE.csv", "with --scan, also write the gap of every blow that counts"},
             {"histories", "A:B", "with -o DIR, also write what happens from blow A to blow B"},
             {"json", "", "print one JSON object in place of the table"},
             {"si", "", "numbers in SI, as if not given"},
             {"dimensionless", "", "numbers as multiples of d0, v0, I0, F0 and t0"},
             {"j", "N", "threads to use, all of them if not given"},
             {"work-limit", "N", "cells times nodes that are permitted, 4e9 if not given"},
             {"o", "FILE.csv|DIR",
              "also write a row for every blow, with FILE.csv.yaml beside, or all files into DIR; - prints "
              "the rows"},
             {"force", "", "overwrite existing files"}}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = [](const Arguments&) { return false; },
        .run = runDrill,
    };
    return command;
}

}  // namespace drillwave
