// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave run FILE
#include <algorithm>

#include "app/command.h"
#include "app/identify_options.h"
#include "app/input_text.h"
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
#include "core/report/blow_json.h"
#include "core/report/blow_text.h"
#include "core/report/gauge_record.h"
#include "core/study/identify/gauge_place.h"
#include "core/study/identify/option_words.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// Output of a run.
struct RunFiles {
    std::string directory;             ///< empty: no files
    std::vector<std::string> plots;    ///< formats
    std::optional<OutputUnits> units;  ///< none: those of the scenario
    Overwrite overwrite = Overwrite::refused;
    std::vector<PlannedGauge> gauges;  ///< of record.csv
    double noise = 0;                  ///< in it, share of the largest strain
    std::uint64_t seed = 1;            ///< of that noise
};

/// The gauges of --record. Throws CommandError: usage; invalid scenario.
void readGauges(const Arguments& arguments, RunFiles& files) {
    constexpr std::size_t mostGauges = 2;
    const std::vector<std::string> words = arguments.values("record");
    checkAboutFiles(arguments, {"record", "noise", "seed"}, "DIR");
    if (words.size() > mostGauges)
        throw CommandError(ExitCode::usage, translatable("--record is for one or two gauges"));
    for (const std::string& word : words) {
        const GaugeChoice gauge = gaugeChoiceOf("record", word);
        files.gauges.push_back({gauge.column, gauge.distance});
        if (!gauge.opposite.empty()) files.gauges.push_back({gauge.opposite, gauge.distance});
    }
    for (const char* option : {"noise", "seed"})
        if (arguments.has(option) && words.empty())
            throw CommandError(ExitCode::usage, Message(translatable("--%1 needs --record COLUMN@DISTANCE"),
                                                        {std::string(option)}));
    files.seed = static_cast<std::uint64_t>(arguments.number("seed", 1, 0, 2'000'000'000));
    const std::optional<std::string> noise = arguments.value("noise");
    if (!noise) return;
    const std::optional<double> share = percentageOf(*noise);
    if (!share || !(*share >= 0 && *share <= 1))
        throw CommandError(ExitCode::invalidScenario,
                           refusedValue("--noise", *noise,
                                        translatable("must be a percentage from 0 to 100 %, such as 1%")));
    files.noise = *share;
}

/// Finds out whether the gauges are on the rod or string.
void checkGauges(const RunFiles& files, const Scenario& scenario, const std::string& path) {
    if (files.gauges.empty()) return;
    if (!hasUnits(scenario))
        throw CommandError(
            ExitCode::invalidScenario,
            about(path, translatable("is given by its dimensionless groups; --record needs physical units")));
    for (const PlannedGauge& gauge : files.gauges)
        if (!gaugePlace(scenario, gauge.distance))
            throw CommandError(
                ExitCode::invalidScenario,
                Message(translatable("--record %1: is not on a uniform section of the rod or string"),
                        {gauge.column}));
}

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
    readGauges(arguments, files);
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
    const bool drawn = run.blow.impact.hasHistories();
    if (!drawn)
        printRemark(translatable("note: the waves of this blow are more than can be kept: no histories.csv, "
                                 "no record and no plots"),
                    style);
    std::vector<NamedFile> further;
    if (!files.plots.empty() && drawn) further = drawing->blow(run.blow, files.plots, interruption.token());
    if (!files.gauges.empty() && drawn)
        further.push_back({gaugeRecordName, gaugeRecordCsv(run.blow, files.gauges, files.noise, files.seed)});
    interruption.check();
    writeFolder(files.directory, runFolder(run, std::move(further)), files.overwrite, &interruption);
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
    checkGauges(files, document.scenario, path);
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
    addThrustMargin(run.blow, interruption.token());
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
         {OptionSpec{"o", "DIR", "write the files of the run into DIR; -o - writes none"},
          OptionSpec{"plots", "png,svg,pdf", "with -o, also write plots in these formats"},
          OptionSpec{"si", "", "with -o, write CSV columns in SI (default for scenarios with units)"},
          OptionSpec{"dimensionless", "", "with -o, write CSV columns in dimensionless form"},
          OptionSpec{"record", "COLUMN@DISTANCE",
                     "with -o, also write the strain that a gauge at this distance from the bit face would "
                     "record, in a column named COLUMN",
                     OptionSpec::Times::repeated},
          OptionSpec{"noise", "SHARE",
                     "white noise to add to --record, in % of its largest strain (default: 0%)"},
          OptionSpec{"seed", "S", "seed of the random numbers for --noise (default: 1)"},
          OptionSpec{"force", "", "overwrite existing files"}, decimalCommaSpec()})
        options.push_back(option);
    return options;
}

}  // namespace

const Command& runCommand() {
    static const std::string details =
        "-o DIR writes scenario.yaml, summary.json, histories.csv and events.csv; each of them contains "
        "the\nscenario, so that `drillwave run` can run it again. With --plots, it also writes the plots "
        "blow.*,\nrock.*, wave_picture.* and rod.*. For drill strings, the histories are taken at the middle "
        "of the\nlongest section. To rehearse a measurement for `identify`, add --record near@1.13m "
        "--record\nfar@2.93m --noise 1%. This also writes record.csv, the strain that two gauges would "
        "record in 1e6\nsamples per second. --record top+bottom@1.13m records two gauges on opposite sides "
        "of the rod,\neach with its own noise.";
    static const Command command{
        .name = "run",
        .operands = "FILE",
        .summary = "solve one blow; print a summary, write histories, events and plots",
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
