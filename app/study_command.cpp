// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study_command.h"

#include <array>

#include "app/axis_argument.h"
#include "app/input_text.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_scenario.h"
#include "core/numeric/available_threads.h"
#include "core/report/blow_csv.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// The question that the command line asks about a scenario. Throws CommandError: usage; invalid scenario.
StudyQuestion questionOf(const Study& study, const Arguments& arguments, const Scenario& scenario,
                         const std::string& path) {
    for (const Message& reason :
         {study.whyNot(scenario), study.lacks ? study.lacks(scenario, plainStyle()) : Message()})
        if (!reason.isEmpty()) throw CommandError(ExitCode::invalidScenario, about(inputName(path), reason));
    if (arguments.has("si") && !hasUnits(scenario))
        throw CommandError(
            ExitCode::usage,
            Message(translatable("--si: %1 is given by its dimensionless groups and has no SI units"),
                    {path}));
    StudyQuestion question{scenario, {}};
    for (const StudyOption& option : study.options)
        if (std::optional<std::string> words = arguments.value(option.key))
            question.words.emplace(option.key, std::move(*words));
    if (const std::optional<StudyProblem> problem = study.problem(question)) {
        const std::string* words = wordsOf(question, problem->option);
        throw CommandError(problem->isUsage ? ExitCode::usage : ExitCode::invalidScenario,
                           words ? refusedValue("--" + std::string(problem->option), *words, problem->reason)
                                 : problem->reason);
    }
    if (!study.axis) return question;
    if (const std::optional<StudyAxis> axis = study.axis(question))
        checkNotSet(arguments, scenario, {&axis->axis, 1},
                    std::array{quotedAxis(std::string(axis->option), *wordsOf(question, axis->option))});
    else if (arguments.has("o"))
        throw CommandError(ExitCode::usage,
                           translatable("-o writes the table of --along; add --along KEY=START:STOP"));
    return question;
}

ExitCode runStudy(const Study& study, const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> csvPath = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    checkAboutFiles(arguments, {"force", "si", "decimal-comma"}, "FILE.csv");
    arguments.checkOnePrinted();
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const int threads = study.threadsHelp.empty() ? availableThreads() : jobsOf(arguments);
    const WorkLimits limits = study.hasWorkLimit ? workLimitsOf(arguments) : WorkLimits();
    const ScenarioDocument document = loadScenarioArgument(path, arguments);
    const StudyQuestion question = questionOf(study, arguments, document.scenario, path);
    if (csvPath) {
        checkOutputIsNoInput(*csvPath, arguments, document);
        checkOutput(*csvPath, overwrite);
        plots.check(arguments, document, overwrite);
    }

    if (csvPath != "-") checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    ShareBar bar(arguments.style());
    const StudyAnswerPtr answer = study.run(question, {.stop = interruption.token(),
                                                       .progress = bar.progress(),
                                                       .threads = threads,
                                                       .limits = limits,
                                                       .isForText = csvPath != "-"});
    interruption.check();
    const auto checkSolved = [&](const Message& gap) {
        if (!gap.isEmpty())
            throw CommandError(
                ExitCode::unsolvedOrFailed,
                about(path, study.hasWorkLimit ? reasonWithHint(gap, arguments, document.scenario) : gap));
    };
    if (!answer->hasRows()) checkSolved(answer->gap());
    const std::string scenarioText = completeScenarioText(document);
    const OutputUnits units = arguments.has("si") ? OutputUnits::si : OutputUnits::dimensionless;
    if (csvPath)
        writeStudy(*csvPath, scenarioHeader(scenarioText) + answer->csv(units),
                   plots.draw(answer.get(), drawing, interruption), overwrite, interruption);
    checkSolved(answer->gap());
    if (csvPath != "-")
        printText(arguments.has("json") ? answer->json(scenarioText) : answer->text(arguments.style()));
    checkSolved(answer->gapInRows());
    return ExitCode::done;
}

}  // namespace

Command studyCommand(const Study& study) {
    std::vector<OptionSpec> options;
    for (const StudyOption& option : study.options)
        options.push_back({option.key, option.value, option.help});
    if (!study.threadsHelp.empty()) options.push_back({"j", "N", study.threadsHelp});
    if (study.hasWorkLimit) options.push_back(workLimitSpec());
    options.push_back({"json", "", "print one JSON object instead of the table"});
    options.push_back({"o", "FILE.csv", study.csvHelp});
    if (study.hasSi) options.push_back({"si", "", "with -o, write columns in SI, with units in the header"});
    for (const OptionSpec& option :
         {plotsOptionSpec(), OptionSpec{"force", "", "overwrite existing files"}, decimalCommaSpec()})
        options.push_back(option);
    return Command{.name = study.name,
                   .operands = "FILE",
                   .summary = study.summary,
                   .details = study.details,
                   .options = scenarioOptions(options),
                   .leastOperands = 1,
                   .mostOperands = 1,
                   .draws = asksForPlots,
                   .run = [&study](const Arguments& arguments, const Drawing* drawing) {
                       return runStudy(study, arguments, drawing);
                   }};
}

}  // namespace drillwave
