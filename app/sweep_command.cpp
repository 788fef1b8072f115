// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave sweep FILE --vary KEY=…
#include "app/axis_argument.h"
#include "app/command.h"
#include "app/method_options.h"
#include "app/preset_options.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/study/rows/sweep_check.h"
#include "core/study/rows/sweep_rows.h"

namespace drillwave {

namespace {

std::vector<SweepAxis> axesOf(const Arguments& arguments, const Scenario& base) {
    const PresetLookup presets = presetLookup(arguments);
    std::vector<SweepAxis> axes;
    for (const std::string& word : arguments.values("vary"))
        axes.push_back(axisOrPresetsArgument("vary", word, base, presets));
    return axes;
}

/// Returns a scenario for --outputs all: an axis may give the blow frequency or thrust that `base` lacks.
Scenario sampleOf(const Scenario& base, const std::vector<SweepAxis>& axes) {
    Scenario sample = base;
    for (const SweepAxis& axis : axes)
        if (axis.parameter && axis.parameter->section() == "drill") axis.assign(sample, axis.value(0));
    return sample;
}

/// Returns the axes as given; parseAxis() has read the words.
std::vector<RecordedAxis> recordedAxes(const std::vector<SweepAxis>& axes, const Arguments& arguments) {
    const std::vector<std::string> words = arguments.values("vary");
    std::vector<RecordedAxis> recorded;
    for (const SweepAxis& axis : axes) {
        const std::string& word = words[recorded.size()];
        recorded.push_back(recordedAxis(axis, word));
    }
    return recorded;
}

ExitCode runSweepCommand(const Arguments& arguments, const Drawing* drawing) {
    if (arguments.values("vary").empty())
        throw CommandError(ExitCode::usage,
                           translatable("needs --vary KEY=START:STOP:COUNT[:log] or --vary KEY=A,B,C"));
    const std::string& path = arguments.operands().front();
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const ScenarioInput input = loadScenarioInput(path, arguments);
    const ScenarioDocument& base = input.document;
    const std::vector<SweepAxis> axes = axesOf(arguments, base.scenario);
    std::vector<std::string> words;
    for (const std::string& word : arguments.values("vary")) words.push_back(quotedAxis("vary", word));
    checkNotSet(arguments, base.scenario, axes, words);
    const RowOptions options = rowOptions(arguments, input.method);
    checkMethodOfString(options.method, input.document.scenario, path);
    checkRows(options, arguments, base);
    plots.check(arguments, base, options.overwrite);
    Sweep sweep{.base = base.scenario,
                .axes = axes,
                .columns = options.columnsFor(sampleOf(base.scenario, axes)),
                .shard = options.shard,
                .method = options.method,
                .workLimit = options.workLimit};
    if (std::vector<Message> problems = problemsOf(sweep); !problems.empty())
        throw CommandError(ExitCode::invalidScenario, eachAbout(path, std::move(problems)));

    if (const Message problem = plots.areWanted() ? pictureProblem(sweep) : Message(); !problem.isEmpty())
        throw CommandError(ExitCode::usage, about("--plots", problem));

    RowRecord record = recordOf("sweep", arguments, options, sweep.columns, base,
                                rowsOf(sweep.shard, pointCount(sweep)).size());
    record.axes = recordedAxes(axes, arguments);
    const Interruption interruption;
    SweepRows rows{.title = base.scenario.title, .axes = axes, .columns = sweep.columns, .numbers = {}};
    const auto run = [&](std::stop_token stop, RowSink& sink, const RowProgress& progress,
                         std::uint64_t done) {
        sweep.done = done;
        if (!plots.areWanted()) return runSweep(sweep, options.jobs, stop, sink, progress);
        RowKeeper keeper(sink, rows.numbers);
        return runSweep(sweep, options.jobs, stop, keeper, progress);
    };
    return writeRows(run, record, options, interruption, arguments.style(),
                     [&] { return plots.draw(&rows, drawing, interruption); });
}

std::vector<OptionSpec> sweepOptions() {
    std::vector<OptionSpec> options{
        {"vary", "KEY=VALUES",
         "vary this parameter; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C; to "
         "compare presets: rock=all, or rock=, hammer=, rod= or bit= with their names",
         OptionSpec::Times::list}};
    for (const OptionSpec& option : rowOptionSpecs()) options.push_back(option);
    options.push_back(plotsOptionSpec());
    return options;
}

}  // namespace

const Command& sweepCommand() {
    static constexpr std::string_view details =
        "Solves one blow for every combination of the --vary values. Each combination is one row; "
        "the\nparameter given last varies fastest. Values carry units where the parameter has one: "
        "--vary\nrod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine\nFILE.csv.yaml beside FILE.csv "
        "records version, command, varied parameters and scenario. --plots\ncan draw one or two varied "
        "parameters. The parameter with more values is the horizontal axis; each\nvalue of the other "
        "parameter gives a curve.";
    static const Command command{
        .name = "sweep",
        .operands = "FILE",
        .summary = "solve one blow for every combination of parameter values, one CSV row each",
        .details = details,
        .furtherHelp = outputHelp,
        .options = sweepOptions(),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runSweepCommand,
    };
    return command;
}

}  // namespace drillwave
