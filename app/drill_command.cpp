// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave drill FILE
#include <algorithm>
#include <iterator>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/drill_options.h"
#include "app/drill_rows.h"
#include "app/drill_scan.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_files.h"
#include "core/archive/result_scenario.h"
#include "core/report/drilling_report.h"
#include "core/study/thrust/thrust_margins.h"

namespace drillwave {

namespace {

const std::vector<std::string> drillFiles{"scenario.yaml", "summary.json", "blows.csv", "histories.csv"};

/// The CSV whose pictures a folder has: drilling.png and so on.
constexpr const char* pictureOwnerOfDrill = "drilling.csv";

/// An option that is short for --set KEY=N.
OptionSpec shortFor(std::string_view key, std::string_view name, std::string_view help) {
    return {name, "N", help, OptionSpec::Times::once, key};
}

bool isFolder(const std::string& out) {
    return !isStream(out) && !out.ends_with(".csv");
}

FolderFiles folderOf(const DrillingReport& report, OutputUnits units, std::vector<NamedFile> pictures) {
    std::vector<NamedFile> files{{"scenario.yaml", report.scenarioText},
                                 {"summary.json", drillingJson(report, units)},
                                 {"blows.csv", drillingCsv(report, units)}};
    if (!report.result.instants.empty())
        files.push_back({"histories.csv", drillingHistoriesCsv(report, units)});
    std::ranges::move(pictures, std::back_inserter(files));
    return {.files = std::move(files),
            .outdated = [](const std::string& there) { return studyFilesThere(there, pictureOwnerOfDrill); }};
}

/// The row of every blow.
void writeBlows(const DrillingReport& report, const Arguments& arguments, OutputUnits units,
                std::vector<NamedFile> beside, const Interruption& interruption) {
    const std::string out = *arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const std::string rows = drillingCsv(report, units);
    if (!isStream(out)) {
        RowRecord record = drillRecord(arguments, report.scenarioText, report.result.blows.size());
        record.outputs = drillingHeaders(report.result, units);
        beside.push_back(drillRecordBeside(out, std::move(record), rows));
    }
    writeStudy(out, rows, std::move(beside), overwrite, interruption);
}

ExitCode runDrill(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> out = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    if (!arguments.has("gaps")) checkAboutFiles(arguments, {"force", "decimal-comma"}, "FILE.csv (or DIR)");
    arguments.checkOnePrinted();
    if (arguments.has("gaps") && !arguments.has("scan"))
        throw CommandError(ExitCode::usage,
                           translatable("--gaps needs a scan; add --scan KEY=START:STOP:COUNT"));
    ScenarioDocument document = loadScenarioArgument(path, arguments);
    if (arguments.has("scan")) return runDrillScan(arguments, document, path, drawing);

    const OutputUnits units = drillUnits(arguments);
    const StudyPlots plots = out && isFolder(*out) ? StudyPlots::inFolder(arguments, "drilling")
                                                   : StudyPlots::besideFile(arguments);
    DrillingSettings settings = drillingSettingsOf(document.scenario);
    settings.cells = drillCells(arguments, settings.cells);
    refuseDrill(drillingRefusals(document.scenario, settings), path);
    DrillingRequest wants;
    wants.histories = drillHistories(arguments, out, settings);
    if (wants.histories && foreseenInstants(document.scenario, settings, *wants.histories) >
                               static_cast<double>(mostDrillingInstants))
        throw CommandError(
            ExitCode::usage,
            Message(
                translatable(
                    "--histories: these blows have more than %1 samples; take fewer blows or fewer --cells"),
                {std::to_string(mostDrillingInstants)}));
    wants.mostWork = permittedDrillWork(arguments);
    wants.jobs = jobsOf(arguments);
    checkDrillWork(drillingWork(document.scenario, settings, wants), arguments);
    if (out && isFolder(*out)) {
        for (const std::string& name : drillFiles)
            checkOutputIsNoInput(*out + "/" + name, arguments, document);
        checkFolder(*out, plots.namesWith(drillFiles), overwrite);
    } else if (out && *out != "-") {
        checkDrillRows(*out, arguments, document, overwrite);
    }
    plots.check(arguments, document, overwrite);
    if (out != "-") checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    remarkOnUnusedOfDrill(document.scenario, path, arguments.style());
    ProgressBar bar(static_cast<std::uint64_t>(foreseenBlows(settings, wants)), translatable("blows"),
                    arguments.style());
    std::uint64_t done = 0;
    DrillingReport report{
        .result = studyDrilling(document.scenario, settings, wants, interruption.token(),
                                [&](long more) { bar.show(done += static_cast<std::uint64_t>(more)); }),
        .feed = solveFeedEstimate(document.scenario, interruption.token()),
        .scenarioText = completeScenarioText(document)};
    interruption.check();
    if (report.result.outcome == DrillingOutcome::notSolved)
        throw CommandError(
            ExitCode::unsolvedOrFailed,
            couldNotBeSolved(path, reasonWithHint(report.result.reason,
                                                  static_cast<long>(std::min(wants.mostWork, 1e18)))));
    std::vector<NamedFile> pictures = plots.draw(&report, drawing, interruption);
    if (out && isFolder(*out))
        writeFolder(*out, folderOf(report, units, std::move(pictures)), overwrite, &interruption);
    else if (out)
        writeBlows(report, arguments, units, std::move(pictures), interruption);
    if (out != "-")
        printText(arguments.has("json") ? drillingJson(report, units)
                                        : drillingText(report, units, arguments.style()));
    return ExitCode::done;
}

}  // namespace

const Command& drillCommand() {
    static const Command command{
        .name = "drill",
        .operands = "FILE",
        .summary = "simulate consecutive blows under a feed force: penetration rate, gaps, errors",
        .details =
            "Simulates consecutive blows. The residual waves and the motion of the machine on its damper "
            "carry\nover from one blow to the next; each blow meets new rock. Prints penetration and "
            "penetration rate\nwith their errors, and the share of blows that start with the bit on the "
            "rock. Also prints whether\nthe motion repeats, and where the energy goes. FILE needs "
            "drill.blow_frequency and drill.thrust,\nthe feed force. Penetrations are upper limits, because "
            "all rock under the bit is assumed to break.\n--scan compares values of a parameter. Each value "
            "is simulated twice: starting at rest and\nstarting with a bouncing machine. A second row is "
            "printed only if the two differ. -o DIR writes "
            "scenario.yaml, summary.json and blows.csv into\nDIR, with --histories also histories.csv, with "
            "--plots also drilling.png.",
        .options = scenarioOptions(
            {shortFor("drill.blows", "blows",
                      "number of blows: short for --set drill.blows=N (default: 1000, with --scan 300)"),
             shortFor("drill.settle", "settle",
                      "number of first blows (transient blows) that the statistics exclude: short for --set "
                      "drill.settle=N"),
             shortFor("drill.seed", "seed",
                      "seed of the random intervals between blows: short for --set drill.seed=N"),
             {"cells", "N",
              "time steps per duration t0 of the blow, 10 to 400 (default: 40, with --scan 20)"},
             {"scan", "KEY=VALUES",
              "vary this parameter and compare its values; VALUES is START:STOP:COUNT, START:STOP:COUNT:log "
              "(equal ratios) or A,B,C, with units"},
             {"gaps", "FILE.csv",
              "with --scan, also write the gap between bit and rock at the start of each blow to this file, "
              "without transient blows"},
             {"histories", "A:B",
              "with -o DIR, also write the motion and forces over time from blow A to blow B"},
             {"json", "", "print one JSON object instead of the table"},
             {"si", "", "print numbers in SI units (default)"},
             {"dimensionless", "",
              "print dimensionless numbers: multiples of the scales d0, v0, I0, F0 and t0 of a blow "
              "(`drillwave help glossary 2`)"},
             {"j", "N", "number of threads (default: all)"},
             {"work-limit", "N",
              "refuse a computation if its number of time steps times its number of section ends is above N "
              "(default: 4e9)"},
             {"o", "FILE.csv|DIR",
              "FILE.csv: also write one row per blow, with the settings in FILE.csv.yaml; DIR: write all "
              "files of the run into DIR; -o - prints the rows"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runDrill,
    };
    return command;
}

}  // namespace drillwave
