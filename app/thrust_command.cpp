// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave thrust FILE
#include <array>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_scenario.h"
#include "core/blow/feed_estimate.h"
#include "core/model/parameter_text.h"
#include "core/numeric/run_time.h"
#include "core/report/blow_csv.h"
#include "core/report/report_text.h"
#include "core/report/thrust_report.h"

namespace drillwave {

namespace {

/// Range requested by --along or --frequency.
std::optional<SweepAxis> axisOf(const Arguments& arguments) {
    const std::optional<std::string> along = arguments.value("along");
    const std::optional<std::string> frequencies = arguments.value("frequency");
    if (!along && !frequencies) return std::nullopt;
    if (along && frequencies)
        throw CommandError(
            ExitCode::usage,
            translatable("--frequency VALUES is --along drill.blow_frequency=VALUES; give one of them"));
    const std::string option = along ? "--along" : "--frequency";
    ParsedAxis parsed =
        parseAxis(along ? *along : "drill.blow_frequency=" + *frequencies, customaryThrustPoints);
    if (!parsed.problem.isEmpty())
        throw CommandError(
            parsed.kind == ParsedAxis::Kind::badValue ? ExitCode::invalidScenario : ExitCode::usage,
            about(option, parsed.problem));
    if (!parsed.axis.parameter)
        throw CommandError(ExitCode::usage,
                           about(option, translatable("pulse.shape is not a number; use sweep for it")));
    if (parsed.axis.count > mostThrustPoints)
        throw CommandError(ExitCode::usage, Message(translatable("%1: at most %2 values"),
                                                    {option, std::to_string(mostThrustPoints)}));
    return std::move(parsed.axis);
}

ThrustCurve curveAlong(const Scenario& scenario, const SweepAxis& axis, int jobs, const WorkLimits& limits,
                       const ReadingStyle& style, const Interruption& interruption) {
    ProgressBar bar(axis.count, translatable("points"), style);
    const auto progress = [&](const ThrustCurve& soFar) { bar.show(soFar.points.size()); };
    ThrustCurve curve =
        thrustAlong(scenario, *axis.parameter, valuesOf(axis), jobs, interruption.token(), progress, limits);
    interruption.check();
    return curve;
}

/// Throws where points have no numbers.
void checkSolved(const ThrustCurve& curve, const std::string& path, const Arguments& arguments,
                 const Scenario& scenario) {
    std::size_t failed = 0;
    Message reason;
    for (const ThrustPoint& point : curve.points) {
        if (point.reason.isEmpty()) continue;
        if (failed++ == 0) reason = point.reason;
    }
    if (failed == 0) return;
    throw CommandError(
        ExitCode::unsolvedOrFailed,
        Message(translatable("%1: %2 of %3 points could not be solved: their cells are empty; the first: %4"),
                {path, std::to_string(failed), std::to_string(curve.points.size()),
                 reasonWithHint(reason, arguments, scenario)}));
}

ThrustStudy study(const Scenario& scenario, const WorkLimits& limits, const ReadingStyle& style,
                  const Interruption& interruption) {
    ShareBar bar(style);
    ThrustStudy found =
        studyThrust(scenario, interruption.token(), bar.progress(), anyNumberOfPieces, limits);
    interruption.check();
    return found;
}

/// Finds out before anything is computed whether there can be an answer.
void checkQuestion(const Scenario& scenario, const std::optional<SweepAxis>& axis, const std::string& path) {
    Message problem = thrustProblem(scenario);
    if (problem.isEmpty() && axis) {
        problem = whyNotApplicable(*axis->parameter, scenario);
        if (!problem.isEmpty())
            problem = {translatable("%1 does not apply here: %2"), {std::string(axis->key()), problem}};
    }
    if (!problem.isEmpty()) throw CommandError(ExitCode::invalidScenario, about(path, problem));
}

ExitCode runThrust(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> csvPath = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const std::optional<SweepAxis> axis = axisOf(arguments);
    if (csvPath && !axis)
        throw CommandError(ExitCode::usage,
                           translatable("-o writes the table of --along; add --along KEY=START:STOP"));
    checkAboutFiles(arguments, {"force", "decimal-comma"}, "FILE.csv");
    arguments.checkOnePrinted();
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const int jobs = jobsOf(arguments);
    const WorkLimits limits = workLimitsOf(arguments);
    const ScenarioDocument document = loadScenarioInput(path, arguments).document;
    ThrustReport report;
    report.scenario = document.scenario;
    report.scenarioText = completeScenarioText(document);
    if (axis)
        checkNotSet(arguments, report.scenario, {&*axis, 1},
                    std::array{quotedAxis(
                        arguments.has("along") ? "along" : "frequency",
                        arguments.value("along").value_or(arguments.value("frequency").value_or("")))});
    checkQuestion(report.scenario, axis, path);
    if (csvPath) {
        checkOutputIsNoInput(*csvPath, arguments, document);
        checkOutput(*csvPath, overwrite);
        plots.check(arguments, document, overwrite);
    }

    if (csvPath != "-") checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(report.scenario, path, arguments.style());
    const Stopwatch watch;
    if (axis)
        report.along = ThrustAlong{
            *axis, curveAlong(report.scenario, *axis, jobs, limits, arguments.style(), interruption)};
    // Before anything is written: whoever interrupts it leaves nothing behind.
    if (csvPath != "-") report.study = study(report.scenario, limits, arguments.style(), interruption);
    report.runTime = watch.seconds();
    if (csvPath)
        writeStudy(*csvPath, scenarioHeader(report.scenarioText) + thrustCsv(*report.along),
                   plots.draw(&report, drawing, interruption), overwrite, interruption);
    if (csvPath != "-") {
        if (!report.study.reason.isEmpty())
            throw CommandError(
                ExitCode::unsolvedOrFailed,
                couldNotBeSolved(path, reasonWithHint(report.study.reason, arguments, report.scenario,
                                                      report.study.hindrance)));
        printText(arguments.has("json") ? thrustJson(report) : thrustText(report, arguments.style()));
    }
    if (report.along) checkSolved(report.along->curve, path, arguments, report.scenario);
    return ExitCode::done;
}

}  // namespace

const Command& thrustCommand() {
    static const std::string details =
        "Prints whether the installed feed force covers single blows, as an estimate, and a table of\n"
        "four cases: this blow, 95 % of all gaps between bit and rock, rigid rock (e = 1), and the worst\n"
        "gap on elastic rock (gamma = 1). With blow frequency f, impulse I0 of a blow and restitution e\n"
        "each case has (theory §10):\n"
        "  required         f I0 (1 + e), the mean force that balances the blow\n"
        "  return in time   f I0 (1 + 2e), with which an undamped rigid rod is back at the rock before\n"
        "                   the next blow\n"
        "  margin           effective over required feed force, less 1\n"
        "  covered up to    blow frequency up to which the effective feed force covers the case\n"
        "Below f I0 the machine is pushed back. With drill.inclination, the effective feed force is the\n"
        "installed one plus the weight of rod and drill.machine_mass along the hole. `drillwave drill`\n"
        "solves consecutive blows. Needs a scenario in physical units with drill.blow_frequency; margins\n"
        "need drill.thrust. For drill strings, I0 is the impulse of the hammer's face; gaps have no\n"
        "period, so only this blow and rigid rock are printed.";
    static const Command command{
        .name = "thrust",
        .operands = "FILE",
        .summary = "required feed force of single blows, and whether the installed one covers it",
        .details = details,
        .options = scenarioOptions({{"along", "KEY=VALUES",
                                     "also a table along a parameter: A,B,C or START:STOP[:COUNT][:log] "
                                     "(default COUNT: 101, or each whole number)"},
                                    {"frequency", "VALUES", "short for --along drill.blow_frequency=VALUES"},
                                    {"j", "N", "number of threads for --along (default: all)"},
                                    workLimitSpec(),
                                    {"json", "", "print one JSON object instead of the tables"},
                                    {"o", "FILE.csv", "also write the table of --along; - prints it instead"},
                                    plotsOptionSpec(),
                                    {"force", "", "overwrite existing files"},
                                    decimalCommaSpec()}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runThrust,
    };
    return command;
}

}  // namespace drillwave
