// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave stability
#include "app/command.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/study_plots.h"
#include "core/numeric/available_threads.h"
#include "core/numeric/run_time.h"
#include "core/report/proof_answer.h"

namespace drillwave {

namespace {

constexpr char stabilityCsvName[] = "stability.csv";

ExitCode endOf(const StabilityReport& report) {
    return report.failed() + report.notSolved() > 0 ? ExitCode::unsolvedOrFailed : ExitCode::done;
}

ExitCode runStability(const Arguments& arguments, const Drawing* drawing) {
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const std::string directory = arguments.value("o").value_or(std::string());
    arguments.checkOnePrinted();
    const bool inFolder = !directory.empty() && directory != "-";
    const StudyPlots plots = StudyPlots::inFolder(arguments, "stability");
    if (inFolder) checkFolder(directory, plots.namesWith({stabilityCsvName}), overwrite);
    checkStandardOutput();
    const Interruption interruption;
    const std::vector<StabilityCase> cases = stabilityCases();
    ProgressBar bar(cases.size(), translatable("cases"), arguments.style());
    const Stopwatch watch;
    const StabilityReport report =
        checkStability(cases, availableThreads(), interruption.token(),
                       [&bar](const StabilityReport& soFar) { bar.show(soFar.rows.size()); });
    const StudyAnswerPtr answer = stabilityAnswer(report, watch.seconds());
    interruption.check();
    if (directory == "-") {
        printText(inCsvSigns(answer->csv(OutputUnits::dimensionless)));
        return endOf(report);
    }
    if (inFolder) {
        FolderFiles folder{plots.draw(answer.get(), drawing, interruption),
                           [](const std::string& there) { return studyFilesThere(there, stabilityCsvName); }};
        folder.files.push_back({stabilityCsvName, answer->csv(OutputUnits::dimensionless)});
        writeFolder(directory, folder, overwrite, &interruption);
    }
    printText(arguments.has("json") ? answer->json({}) : answer->text(arguments.style()));
    return endOf(report);
}

}  // namespace

const Command& stabilityCommand() {
    static const Command command{
        .name = "stability",
        .operands = "",
        .summary = "check the solver on stiff and extreme cases",
        .details =
            "Solves some thousand cases: published cases, difficult cases, each parameter through its "
            "whole\nrange, and extreme combinations for every shape of the blow. Checks that momentum and "
            "energy are\nbalanced, that the rock does not pull, and that no contact was missed. Also checks "
            "that e hardly\nchanges if a parameter changes by 1e-10. Compares the results with the limits of "
            "soft and rigid\nrock, and with the lattice method if its steps are short enough. Compares the "
            "stated error with a\nmore precise solution (long double). Exit code 6 if any check fails.\nTwo "
            "ranges are not covered, because the exact solver would split the waves into more than "
            "30\nmillion pieces. They are beta below 1e-6 with gamma below 1, and tau below 0.1 with "
            "exponential\nand piston blows.",
        .options =
            {{"json", "", "print one JSON object with all cases"},
             {"o", "DIR",
              "write a table of all cases to stability.csv in DIR; -o - prints it instead of the summary"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()},
        .leastOperands = 0,
        .mostOperands = 0,
        .draws = asksForPlots,
        .run = runStability,
    };
    return command;
}

}  // namespace drillwave
