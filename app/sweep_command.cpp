// drillwave sweep FILE --vary KEY=…
#include "app/command.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/model/decimal_text.h"
#include "core/study/sweep.h"

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

ExitCode runSweepCommand(const Arguments& arguments) {
    const RowOptions options = rowOptions(arguments);
    const std::string& path = arguments.operands().front();
    const std::vector<SweepAxis> axes = axesOf(arguments);
    const ScenarioDocument base = loadScenarioArgument(path, arguments);
    checkOutputIsNoInput(options.path, path, base);
    const Sweep sweep{.base = base.scenario,
                      .axes = axes,
                      .columns = options.columns,
                      .shard = options.shard,
                      .method = options.method,
                      .workLimit = options.workLimit};
    if (std::vector<std::string> problems = problemsOf(sweep); !problems.empty()) {
        for (std::string& problem : problems) problem = path + ": " + problem;
        throw CommandError(ExitCode::invalidScenario, std::move(problems));
    }

    const Interruption interruption;
    OutputFile out(options.path, options.overwrite);
    const auto run = [&](std::stop_token stop, const WriteText& write, const RowProgress& progress) {
        return runSweep(sweep, options.jobs, stop, write, progress);
    };
    return writeRows(run, rowsOf(sweep.shard, pointCount(sweep)).size(), options, out, interruption);
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
        "where the parameter has one: --vary rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine\n" +
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
