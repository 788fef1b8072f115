// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave thrust FILE
#include "app/command.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/scenario_argument.h"
#include "core/blow/thrust.h"
#include "core/file/result_scenario.h"
#include "core/report/blow_csv.h"
#include "core/report/report_text.h"
#include "core/report/thrust_report.h"

namespace drillwave {

namespace {

constexpr std::uint64_t mostFrequencies = 10'000;

std::optional<SweepAxis> frequenciesOf(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("frequency");
    if (!text) return std::nullopt;
    ParsedAxis parsed = parseAxis("drill.blow_frequency=" + *text);
    if (!parsed.problem.empty())
        throw CommandError(
            parsed.kind == ParsedAxis::Kind::badValue ? ExitCode::invalidScenario : ExitCode::usage,
            "--frequency: " + parsed.problem);
    if (parsed.axis.count > mostFrequencies)
        throw CommandError(ExitCode::usage, "--frequency: at most " + std::to_string(mostFrequencies) +
                                                " frequencies; the thrust is proportional to them anyway");
    return std::move(parsed.axis);
}

ThrustStudy study(const Scenario& scenario, const Interruption& interruption) {
    constexpr double parts = 1000;
    ProgressBar bar(static_cast<std::uint64_t>(parts));
    const auto progress = [&](double done) { bar.show(static_cast<std::uint64_t>(done * parts)); };
    ThrustStudy found = studyThrust(scenario, interruption.token(), progress);
    interruption.check();
    return found;
}

ExitCode runThrust(const Arguments& arguments, const Drawing*) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> csvPath = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    ThrustReport report{
        .scenario = {}, .study = {}, .frequencies = frequenciesOf(arguments), .scenarioText = {}};
    if (csvPath && !report.frequencies)
        throw CommandError(ExitCode::usage,
                           "-o writes the table of --frequency; add --frequency START:STOP:COUNT");
    if (arguments.has("force") && !csvPath)
        throw CommandError(ExitCode::usage, "--force is about the file of -o; add -o FILE.csv");
    const ScenarioDocument document = loadScenarioArgument(path, arguments);
    report.scenario = document.scenario;
    report.scenarioText = completeScenarioText(document);
    if (const std::string problem = thrustProblem(report.scenario); !problem.empty())
        throw CommandError(ExitCode::invalidScenario, path + ": " + problem);
    if (csvPath) {
        checkOutputIsNoInput(*csvPath, path, document);
        checkOverwrite(*csvPath, overwrite);
    }

    const Interruption interruption;
    remarkOnValues(report.scenario, path);
    report.study = study(report.scenario, interruption);
    if (!report.study.reason.empty())
        throw CommandError(ExitCode::unsolvedOrFailed,
                           path + ": could not be solved: " + report.study.reason);
    if (csvPath) writeFile(*csvPath, scenarioHeader(report.scenarioText) + thrustCsv(report), overwrite);
    if (csvPath == "-") return ExitCode::done;
    writeFile("-", arguments.has("json") ? thrustJson(report) : thrustText(report), Overwrite::allowed);
    return ExitCode::done;
}

}  // namespace

const Command& thrustCommand() {
    static const std::string details =
        "With blow frequency f, impulse I0 of a blow and restitution e, the installed thrust is judged so:\n"
        "  below f I0            the blows push the machine back\n"
        "  below f I0 (1+e)      penetration is lost\n"
        "  below f I0 (1+2e)     full rate, but the bit leaves the rock between blows, unless the machine "
        "damps\n"
        "  from there on         the bit is back before the next blow; over-feeding (friction, buckling,\n"
        "                        stalling) is outside the model\n"
        "The verdict is by the e of this blow. Beside it, each with its own e: 95 % of all gaps between bit\n"
        "and rock, rigid rock (e = 1), and the worst gap on elastic rock (gamma = 1). A margin is the\n"
        "installed thrust over f I0 (1+e), less 1; thrust_margin is that of the largest need. Needs a\n"
        "scenario in physical units with drill.blow_frequency; verdict and margins need drill.thrust.";
    static const Command command{
        .name = "thrust",
        .operands = "FILE",
        .summary = "thrust that blows need, and what the installed one does between them",
        .details = details,
        .options = scenarioOptions(
            {{"frequency", "VALUES", "also a table against frequency: 40Hz:80Hz:5, or 40Hz,60Hz"},
             {"json", "", "print one JSON object in place of the tables"},
             {"o", "FILE.csv", "also write the table of --frequency; - prints it instead"},
             {"force", "", "overwrite an existing file"}}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = [](const Arguments&) { return false; },
        .run = runThrust,
    };
    return command;
}

}  // namespace drillwave
