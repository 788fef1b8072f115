// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave run FILE
#include <algorithm>

#include "app/command.h"
#include "app/interruption.h"
#include "app/method_options.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_files.h"
#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/report/blow_json.h"
#include "core/report/blow_text.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// Where the files of a run go.
struct RunFiles {
    std::string directory;             ///< empty: no files
    std::vector<std::string> plots;    ///< formats
    std::optional<OutputUnits> units;  ///< if not given, those of the scenario
    Overwrite overwrite = Overwrite::refused;
};

RunFiles filesOf(const Arguments& arguments) {
    RunFiles files;
    files.overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    files.directory = arguments.value("o").value_or("-");
    if (files.directory == "-") files.directory.clear();
    if (arguments.has("si")) files.units = OutputUnits::si;
    if (arguments.has("dimensionless")) {
        if (files.units)
            throw CommandError(ExitCode::usage, translatable("--si and --dimensionless cannot be combined"));
        files.units = OutputUnits::dimensionless;
    }
    files.plots = plotFormats(arguments);
    checkAboutFiles(arguments, {"plots", "si", "dimensionless", "force", "decimal-comma"}, "DIR");
    return files;
}

/// Finds out before anything is computed whether the files can be written.
void prepare(const RunFiles& files, const Arguments& arguments, const ScenarioDocument& document) {
    if (files.directory.empty()) return;
    const std::vector<std::string> names = runFileNames(files.plots);
    for (const std::string& name : names)
        checkOutputIsNoInput(files.directory + "/" + name, arguments, document);
    checkFolder(files.directory, names, files.overwrite);
}

/// Solves, and times the solve alone: where it is quick, a second time, because the first one pays for fresh
/// memory.
Blow solve(MethodSolver solver, const Scenario& scenario, const MethodChoice& choice, Detail detail,
           const ReadingStyle& style, const std::stop_token& stop) {
    constexpr double quick = 1e-3;
    const auto solveOnce = [&] {
        return solveBlow(scenario, choice, detail, stop, Stresses::wanted, solver);
    };
    const ElapsedTime elapsed(style);
    Blow blow = solveOnce();
    return blow.runTime < quick ? solveOnce() : blow;
}

void writeFiles(const RunFiles& files, const SolvedRun& run, const Drawing* drawing,
                const ReadingStyle& style, const Interruption& interruption) {
    std::vector<NamedFile> pictures;
    const bool drawn = run.blow.impact.hasHistories();
    if (!drawn)
        printRemark(
            translatable(
                "note: the waves of this blow are more than can be kept: no histories.csv and no plots"),
            style);
    if (!files.plots.empty() && drawn) pictures = drawing->blow(run.blow, files.plots, interruption.token());
    interruption.check();
    writeFolder(files.directory, runFolder(run, std::move(pictures)), files.overwrite, &interruption);
}

void print(const SolvedRun& run, const RunFiles& files, bool json, const ReadingStyle& style) {
    std::string text = json ? blowJson(run.blow, run.scenarioText) : blowText(run.blow, style);
    if (!json && !files.directory.empty())
        text += "  " + style.said({translatable("files in %1"), {files.directory}}) + "\n";
    printText(text);
}

ExitCode runBlow(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const RunFiles files = filesOf(arguments);
    const bool json = arguments.has("json");
    const ScenarioInput input = loadScenarioInput(path, arguments);
    const ScenarioDocument& document = input.document;
    const MethodChoice choice = methodChoice(arguments, input.method);
    checkMethodApplies(choice, document.scenario, path);
    if (files.units == OutputUnits::si && !hasUnits(document.scenario))
        throw CommandError(
            ExitCode::usage,
            Message(translatable("--si: %1 is given by its dimensionless groups and has no SI units"),
                    {path}));
    prepare(files, arguments, document);

    const bool writesFiles = !files.directory.empty();
    checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    SolvedRun run{.blow = solve(MethodSolver(workLimitsOf(arguments)), document.scenario, choice,
                                writesFiles ? Detail::histories : Detail::ledger, arguments.style(),
                                interruption.token()),
                  .scenarioText = {},
                  .units = files.units.value_or(customaryUnits(document.scenario))};
    if (gapHasPeriod(run.blow.scenario)) addThrustMargin(run.blow, interruption.token());
    if (json || writesFiles) run.scenarioText = completeScenarioText(document);
    interruption.check();
    if (!run.blow.isSolved()) {
        if (json) print(run, {}, json, arguments.style());
        throw CommandError(
            ExitCode::unsolvedOrFailed,
            couldNotBeSolved(path, reasonWithHint(run.blow.impact.reason, arguments, run.blow.scenario,
                                                  run.blow.impact.hindrance)));
    }
    if (writesFiles) writeFiles(files, run, drawing, arguments.style(), interruption);
    print(run, files, json, arguments.style());
    return ExitCode::done;
}

std::vector<OptionSpec> runOptions() {
    std::vector<OptionSpec> options =
        scenarioOptions({{"json", "", "print one JSON object instead of the summary"}});
    for (const OptionSpec& option : methodOptionSpecs()) options.push_back(option);
    options.push_back(workLimitSpec());
    for (const OptionSpec& option :
         {OptionSpec{"o", "DIR", "write the files of the run into DIR; - writes none"},
          OptionSpec{"plots", "png,svg,pdf", "with -o, also plots in these formats"},
          OptionSpec{"si", "", "with -o, CSV columns in SI (default for scenarios with units)"},
          OptionSpec{"dimensionless", "", "with -o, CSV columns dimensionless"},
          OptionSpec{"force", "", "overwrite existing files"}, decimalCommaSpec()})
        options.push_back(option);
    return options;
}

}  // namespace

const Command& runCommand() {
    static const std::string details =
        "With -o, DIR gets scenario.yaml, summary.json, histories.csv, "
        "events.csv and the plots: each of the\n"
        "first four can be run again. For drill strings, the histories are taken at the middle of the "
        "longest\nsection. The plots are blow.*, rock.*, wave_picture.* and rod.*.";
    static const Command command{
        .name = "run",
        .operands = "FILE",
        .summary = "solve one blow; a summary, and histories, events and plots into a folder",
        .details = details,
        .options = runOptions(),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runBlow,
    };
    return command;
}

}  // namespace drillwave
