// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drill_scan.h"

#include <filesystem>

#include "app/axis_argument.h"
#include "app/drill_options.h"
#include "app/drill_rows.h"
#include "app/interruption.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_scenario.h"
#include "core/report/drilling_scan_report.h"

namespace drillwave {

namespace {

/// The table of a scan and its gaps: one set where they are in one folder.
void writeScan(const DrillingScanReport& report, const Arguments& arguments, OutputUnits units,
               std::vector<NamedFile> beside, const Interruption& interruption) {
    namespace fs = std::filesystem;
    const std::optional<std::string> out = arguments.value("o"), gaps = arguments.value("gaps");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const bool isFile = out && !isStream(*out);
    const std::string rows = drillingScanCsv(report, units);
    if (isFile) {
        RowRecord record = drillRecord(arguments, report.scenarioText, report.scan.points.size());
        record.axes.push_back(recordedAxis(report.scan.axis, *arguments.value("scan")));
        for (const OutputColumn& column : drillingScanColumns(units))
            record.outputs.push_back(column.header());
        beside.push_back(drillRecordBeside(*out, std::move(record), rows));
    }
    const bool isOneSet =
        isFile && gaps && !isStream(*gaps) && fs::path(*out).parent_path() == fs::path(*gaps).parent_path();
    if (isOneSet)
        beside.push_back({fs::path(*gaps).filename().string(), drillingGapsCsv(report, units)});
    else if (gaps)
        writeStudy(*gaps, drillingGapsCsv(report, units), {}, overwrite, interruption);
    if (out) writeStudy(*out, rows, std::move(beside), overwrite, interruption);
}

/// Throws where values have no answer.
void checkAnswers(const DrillingScan& scan, const std::string& path) {
    std::size_t failed = 0;
    Message reason;
    for (const DrillingScanPoint& point : scan.points) {
        if (point.result.outcome != DrillingOutcome::notSolved) continue;
        if (failed++ == 0) reason = point.result.reason;
    }
    if (failed == 0) return;
    throw CommandError(
        ExitCode::unsolvedOrFailed,
        Message(translatable("%1: %2 of %3 rows could not be solved: their cells are empty; the first: %4"),
                {path, std::to_string(failed), std::to_string(scan.points.size()), reason}));
}

}  // namespace

ExitCode runDrillScan(const Arguments& arguments, const ScenarioDocument& document, const std::string& path,
                      const Drawing* drawing) {
    const OutputUnits units = drillUnits(arguments);
    const std::string word = *arguments.value("scan");
    if (arguments.has("histories"))
        throw CommandError(
            ExitCode::usage,
            translatable(
                "--histories and --scan cannot be combined: a scan has many sequences; take one of them"));
    const ParsedAxis parsed = parseAxis(word);
    if (!parsed.problem.isEmpty()) throw CommandError(ExitCode::usage, about("--scan", parsed.problem));
    const SweepAxis& axis = parsed.axis;
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    if (plots.areWanted() && !axis.parameter)
        throw CommandError(
            ExitCode::usage,
            Message(
                translatable("--plots: a scan over %1 has words on its axis and no picture; scan a number"),
                {std::string(axis.key())}));
    checkNotSet(arguments, document.scenario, std::span(&axis, 1), std::vector{quotedAxis("scan", word)});
    DrillingSettings settings = scanSettingsOf(document.scenario);
    settings.cells = drillCells(arguments, scanCells);
    refuseDrill(scanRefusals(document.scenario, axis, settings), path);
    Scenario first = document.scenario;
    (void)axis.assign(first, axis.value(0));
    checkDrillWork(static_cast<double>(axis.count) * scanWork(first, settings), arguments);
    const std::optional<std::string> out = arguments.value("o"), gaps = arguments.value("gaps");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    for (const std::optional<std::string>& file : {out, gaps})
        if (file && *file != "-") checkDrillRows(*file, arguments, document, overwrite);
    plots.check(arguments, document, overwrite);
    if (out && gaps && *out == *gaps)
        throw CommandError(ExitCode::usage, translatable("-o and --gaps name the same file; give two"));
    const int jobs = jobsOf(arguments);
    checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    remarkOnUnusedOfDrill(first, path, arguments.style());
    ProgressBar bar(axis.count, translatable("values"), arguments.style());
    std::uint64_t done = 0;
    DrillingScanReport report{
        .scan = scanDrilling(
            document.scenario, axis, settings,
            {.jobs = jobs,
             .mostWork = permittedDrillWork(arguments),
             .lyapunov = out || arguments.has("json"),  // the text has none of it
             .stop = interruption.token(),
             .progress = [&](long more) { bar.show(done += static_cast<std::uint64_t>(more)); }}),
        .scenarioText = completeScenarioText(document)};
    interruption.check();
    writeScan(report, arguments, units, plots.draw(&report, drawing, interruption), interruption);
    if (out != "-")
        printText(arguments.has("json") ? drillingScanJson(report, units)
                                        : drillingScanText(report, units, arguments.style()));
    checkAnswers(report.scan, path);
    return ExitCode::done;
}

}  // namespace drillwave
