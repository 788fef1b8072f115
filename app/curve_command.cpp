// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave curve FILE --along KEY=…
#include <algorithm>
#include <filesystem>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/method_options.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/numeric/run_time.h"
#include "core/report/curve_report.h"
#include "core/report/curve_text.h"
#include "core/report/goal_report.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// Levels are of all outputs: they have a unit where these have one in common.
std::vector<double> levelsOf(const Arguments& arguments, const std::vector<OutputColumn>& columns) {
    const Quantity first = columns.front().quantity();
    const bool isCommon =
        std::ranges::all_of(columns, [&](const OutputColumn& column) { return column.quantity() == first; });
    return levelArguments(arguments, isCommon ? first : Quantity::ratio);
}

/// Returns --goal for the only output; a unit may follow the number if the column has one.
std::optional<double> goalOf(const Arguments& arguments, const std::vector<OutputColumn>& columns) {
    const std::optional<std::string> word = arguments.value("goal");
    if (!word) return std::nullopt;
    if (columns.size() != 1)
        throw CommandError(ExitCode::usage,
                           Message(translatable("--goal needs one output; --outputs names %1"),
                                   {std::to_string(columns.size())}));
    if (word->find('=') != std::string::npos)
        throw CommandError(ExitCode::usage,
                           translatable("--goal takes the value alone: --outputs cor --goal 1"));
    const OutputColumn& column = columns.front();
    const Quantity quantity = column.output->siQuantity();
    const bool hasUnit = column.hasUnit();
    if (!hasUnit && quantity != Quantity::ratio && !parseNumber(*word) &&
        parseQuantity(*word, quantity, BareNumber::inDefaultUnit).valid())
        throw CommandError(
            ExitCode::usage,
            Message(translatable("--goal %1: without --si %2 is a number without a unit; add --si"),
                    {shortened(*word), std::string(column.output->name)}));
    return quantityArgument("goal", *word, hasUnit ? quantity : Quantity::ratio);
}

/// Returns the axes in the order of CurveQuestion::axes().
std::vector<std::string> quotedAxes(const Arguments& arguments) {
    std::vector<std::string> words;
    for (const char* option : {"family", "along"})
        if (const std::optional<std::string> word = arguments.value(option))
            words.push_back(quotedAxis(option, *word));
    return words;
}

CurveQuestion questionOf(const Arguments& arguments, const RowOptions& options, const Scenario& base) {
    const std::optional<std::string> along = arguments.value("along");
    if (!along)
        throw CommandError(ExitCode::usage,
                           translatable("needs --along KEY=START:STOP or KEY=START:STOP:log"));
    CurveQuestion question{.base = base,
                           .along = rangeArgument("along", *along),
                           .family = {},
                           .columns = {},
                           .levels = {},
                           .method = options.method,
                           .workLimit = options.workLimit};
    if (const std::optional<std::string> family = arguments.value("family"))
        question.family = axisArgument("family", *family);
    checkNotSet(arguments, base, question.axes(), quotedAxes(arguments));
    question.columns = options.columnsFor(question.firstScenario());
    if (options.allOutputs)
        std::erase_if(question.columns,
                      [](const OutputColumn& column) { return column.output->needsThrustStudy(); });
    question.levels = levelsOf(arguments, question.columns);
    question.goal = goalOf(arguments, question.columns);
    return question;
}

CurveReport study(const CurveQuestion& question, int jobs, const ReadingStyle& style,
                  const Interruption& interruption) {
    ShareBar bar(style);
    const Stopwatch watch;
    CurveReport report{studyCurve(question, jobs, interruption.token(), bar.progress()), 0, {}};
    interruption.check();
    report.runTime = watch.seconds();
    return report;
}

void writeCsv(const CurveReport& report, const Arguments& arguments, const RowOptions& options,
              const ScenarioDocument& base, std::vector<NamedFile> pictures,
              const Interruption& interruption) {
    const CurveQuestion& question = report.study.question;
    RowRecord record = recordOf("curve", arguments, options, question.columns, base, rowCount(report.study));
    if (question.family) record.axes.push_back(recordedAxis(*question.family, *arguments.value("family")));
    record.axes.push_back(recordedAxis(question.along, *arguments.value("along")));
    record.axes.back().count = 0;  // each line has its own points
    OutputFile out(options.path, options.overwrite);
    out.write(curveCsv(report.study));
    std::vector<NamedFile> beside = std::move(pictures);
    if (question.goal)
        beside.push_back({std::filesystem::path(goalName(options.path)).filename(), goalCsv(report.study)});
    commitRows(out, options, record, std::move(beside), interruption);
}

/// Finds out before anything is computed whether the file of the goal can be written.
void checkGoalFile(const Arguments& arguments, const RowOptions& options, const ScenarioDocument& base) {
    if (!arguments.has("goal") || !arguments.has("o")) return;
    if (isStream(options.path))
        throw CommandError(ExitCode::usage, translatable("--goal cannot be used with -o -, which prints the "
                                                         "curve; leave out -o, or give -o FILE.csv"));
    const std::string path = goalName(options.path);
    checkOutputIsNoInput(path, arguments, base);
    checkOverwrite(path, options.overwrite);
}

/// Throws where a line takes the goal nowhere, with the value that comes nearest.
void checkReached(const CurveStudy& study, const std::string& path, const ReadingStyle& style) {
    const std::vector<Message> problems = goalProblems(study, style);
    if (!problems.empty()) throw CommandError(ExitCode::unsolvedOrFailed, eachAbout(path, problems));
}

/// Throws where a line has no answer, with the first reason.
void checkSolved(const CurveStudy& study, const std::string& path, long workLimit,
                 const ReadingStyle& style) {
    for (const CurveLine& line : study.lines)
        for (const CurveOutput& output : line.outputs)
            for (const CurveStretch& stretch : output.unsolved)
                throw CommandError(
                    ExitCode::unsolvedOrFailed,
                    Message(translatable("%1: could not be solved everywhere: from %2 = %3 to %4: %5"),
                            {path, std::string(study.question.along.key()),
                             valueText(study.question.along, stretch.start, valueDigits, style),
                             valueText(study.question.along, stretch.end, valueDigits, style),
                             reasonWithHint(stretch.reason, workLimit)}));
}

ExitCode runCurve(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const bool writesFile = arguments.has("o");
    checkAboutFiles(arguments, {"force", "decimal-comma"}, "FILE.csv");
    arguments.checkOnePrinted();
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const ScenarioInput input = loadScenarioInput(path, arguments);
    const ScenarioDocument& base = input.document;
    const RowOptions options = rowOptions(arguments, input.method);
    checkMethodOfString(options.method, input.document.scenario, path);
    const CurveQuestion question = questionOf(arguments, options, base.scenario);
    if (std::vector<Message> problems = problemsOf(question); !problems.empty())
        throw CommandError(ExitCode::invalidScenario, eachAbout(path, std::move(problems)));
    if (writesFile) checkRows(options, arguments, base);
    checkGoalFile(arguments, options, base);
    if (options.path != "-" || !writesFile) checkStandardOutput();
    plots.check(arguments, base, options.overwrite);

    const Interruption interruption;
    remarkOnValues(base.scenario, path, arguments.style());
    CurveReport report = study(question, options.jobs, arguments.style(), interruption);
    report.scenarioText = completeScenarioText(base);
    if (writesFile)
        writeCsv(report, arguments, options, base, plots.draw(&report, drawing, interruption), interruption);
    if (!writesFile || options.path != "-")
        printText(arguments.has("json") ? curveJson(report) : curveText(report, arguments.style()));
    checkReached(report.study, path, arguments.style());
    checkSolved(report.study, path, options.workLimit, arguments.style());
    return ExitCode::done;
}

std::vector<OptionSpec> curveOptions() {
    std::vector<OptionSpec> options = scenarioOptions(
        {{"along", "KEY=RANGE",
          "parameter to follow continuously from START to STOP; with :log, its axis is logarithmic"},
         {"family", "KEY=VALUES",
          "vary this parameter, with one curve for each value; VALUES is START:STOP:COUNT, "
          "START:STOP:COUNT:log (equal ratios) or A,B,C"},
         {"outputs", "A,B|all",
          "outputs to compute along the parameter, listed below (default: cor, the coefficient of "
          "restitution)"},
         {"level", "X",
          "also print where an output crosses this value; give the value in the unit of the output's column",
          OptionSpec::Times::repeated},
         {"goal", "X",
          "print each parameter value at which the output is X. X is in the unit of the output's column. "
          "Exit code 6 if there is no such value"},
         {"json", "", "print one JSON object instead of the tables"},
         {"si", "", "print and write outputs in SI"}});
    for (const OptionSpec& option : methodOptionSpecs()) options.push_back(option);
    for (const OptionSpec& option : std::initializer_list<OptionSpec>{
             {"work-limit", "N",
              "skip blows whose waves the exact solver must split into more than N pieces (default: "
              "1000000)"},
             {"j", "N", "number of threads (default: all)"},
             {"o", "FILE.csv",
              "also write the curve to FILE.csv, the settings to FILE.csv.yaml and the --goal values to "
              "FILE_goal.csv; -o - prints the points instead of the tables"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()})
        options.push_back(option);
    return options;
}

}  // namespace

const Command& curveCommand() {
    static constexpr std::string_view details =
        "Follows outputs continuously over the range of a parameter, and finds every kink and jump. "
        "For\neach output, prints where it is smallest and largest, its other minima and maxima, its kinks "
        "and\nits jumps. Also prints where the output crosses a --level. All values have errors. If "
        "following an\noutput takes too much computing, it is solved only at single points, and the table "
        "says so.\n--goal X prints every value of the parameter at which the output is X, with its error, "
        "and whether\nthere may be others. If no value gives X, prints the output nearest to X and where it "
        "occurs. Give\nvalues with units if the parameter has one: --along "
        "bit_rock.stiffness=10MN/m:10GN/m:log";
    static const Command command{
        .name = "curve",
        .operands = "FILE",
        .summary =
            "vary one parameter: extremes, kinks and jumps of outputs, and where they reach a goal, with "
            "errors",
        .details = details,
        .furtherHelp = outputHelp,
        .options = curveOptions(),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runCurve,
    };
    return command;
}

}  // namespace drillwave
