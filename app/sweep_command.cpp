// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave sweep FILE --vary KEY=…
#include "app/command.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

std::vector<SweepAxis> axesOf(const Arguments& arguments) {
    std::vector<SweepAxis> axes;
    for (const std::string& word : arguments.values("vary")) {
        ParsedAxis parsed = parseAxis(word);
        if (!parsed.problem.empty()) {
            // A value that the parameter cannot take is like one in a file; anything else is a mistyped
            // command.
            const bool badValue = parsed.kind == ParsedAxis::Kind::badValue;
            throw CommandError(badValue ? ExitCode::invalidScenario : ExitCode::usage,
                               "--vary: " + parsed.problem);
        }
        checkNotSet(arguments, parsed.axis.key(), "--vary " + shortened(word));
        axes.push_back(std::move(parsed.axis));
    }
    if (axes.empty())
        throw CommandError(ExitCode::usage, "needs --vary KEY=START:STOP:COUNT[:log] or --vary KEY=A,B,C");
    return axes;
}

/// What --outputs all may hold: an axis may give the blow frequency or the thrust that the scenario lacks.
Scenario sampleOf(const Scenario& base, const std::vector<SweepAxis>& axes) {
    Scenario sample = base;
    for (const SweepAxis& axis : axes)
        if (axis.parameter && axis.parameter->section() == "drill") axis.assign(sample, axis.value(0));
    return sample;
}

/// The axes as they were asked for; parseAxis() has read the words.
std::vector<RecordedAxis> recordedAxes(const std::vector<SweepAxis>& axes, const Arguments& arguments) {
    const std::vector<std::string> words = arguments.values("vary");
    std::vector<RecordedAxis> recorded;
    for (const SweepAxis& axis : axes) {
        const std::string& word = words[recorded.size()];
        recorded.push_back({axis.column().header, word.substr(word.find('=') + 1), axis.count});
    }
    return recorded;
}

ExitCode runSweepCommand(const Arguments& arguments, const Drawing*) {
    const std::string& path = arguments.operands().front();
    const std::vector<SweepAxis> axes = axesOf(arguments);
    const ScenarioInput input = loadScenarioInput(path, arguments);
    const ScenarioDocument& base = input.document;
    const RowOptions options = rowOptions(arguments, input.method);
    for (const std::string& output : {options.path, RowFile::recordPath(options.path)})
        checkOutputIsNoInput(output, path, base);
    const Sweep sweep{.base = base.scenario,
                      .axes = axes,
                      .columns = options.columnsFor(sampleOf(base.scenario, axes)),
                      .shard = options.shard,
                      .method = options.method,
                      .workLimit = options.workLimit};
    if (std::vector<std::string> problems = problemsOf(sweep); !problems.empty()) {
        for (std::string& problem : problems) problem = path + ": " + problem;
        throw CommandError(ExitCode::invalidScenario, std::move(problems));
    }

    RowRecord record = recordOf("sweep", arguments, options, sweep.columns, base,
                                rowsOf(sweep.shard, pointCount(sweep)).size());
    record.axes = recordedAxes(axes, arguments);
    const Interruption interruption;
    RowFile out(options);
    const auto run = [&](std::stop_token stop, RowSink& sink, const RowProgress& progress) {
        return runSweep(sweep, options.jobs, stop, sink, progress);
    };
    return writeRows(run, record, options, out, interruption);
}

std::vector<OptionSpec> sweepOptions() {
    std::vector<OptionSpec> options{{"vary", "KEY=VALUES",
                                     "an axis: START:STOP:COUNT, START:STOP:COUNT:log or A,B,C",
                                     OptionSpec::Times::list}};
    for (const OptionSpec& option : rowOptionSpecs()) options.push_back(option);
    return options;
}

}  // namespace

const Command& sweepCommand() {
    static const std::string details =
        "Every combination of the values of the axes is one row, later axes fastest. Values carry units\n"
        "where the parameter has one: --vary rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine\n"
        "FILE.csv.yaml beside FILE.csv says what the rows are: version, command, axes and scenario.\n" +
        outputHelp();
    static const Command command{
        .name = "sweep",
        .operands = "FILE",
        .summary = "solve a grid of parameters, one CSV row per point",
        .details = details,
        .options = sweepOptions(),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = [](const Arguments&) { return false; },
        .run = runSweepCommand,
    };
    return command;
}

}  // namespace drillwave
