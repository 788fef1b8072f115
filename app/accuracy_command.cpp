// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave accuracy FILE
#include <algorithm>
#include <charconv>

#include "app/command.h"
#include "app/interruption.h"
#include "app/method_options.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/report/blow_csv.h"
#include "core/report/proof_answer.h"
#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

constexpr std::size_t longestLadder = 30;
constexpr char accuracyCsvName[] = "accuracy.csv";

/// "100,200,500" in growing order.
std::vector<int> ladderOf(const Arguments& arguments) {
    const std::optional<std::string> list = arguments.value("segments");
    if (!list) return latticeLadder();
    std::vector<int> ladder;
    for (std::string_view rest = *list; ladder.size() <= longestLadder; rest.remove_prefix(1)) {
        int segments = 0;
        const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), segments);
        if (read.ec != std::errc() || segments < minimumSegments || segments > maximumSegments) break;
        ladder.push_back(segments);
        rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
        if (rest.empty()) {
            std::ranges::sort(ladder);
            ladder.erase(std::ranges::unique(ladder).begin(), ladder.end());
            return ladder;
        }
        if (rest.front() != ',') break;
    }
    throw CommandError(
        ExitCode::usage,
        Message(
            translatable("--segments %1: needs at most %2 whole numbers from %3 to %4, as in 100,1000,10000"),
            {shortened(*list), std::to_string(longestLadder), std::to_string(minimumSegments),
             std::to_string(maximumSegments)}));
}

/// "100,1000,10000", as --segments takes them.
std::string segmentsText(const std::vector<int>& ladder) {
    std::string text;
    for (const int segments : ladder) text += (text.empty() ? "" : ",") + std::to_string(segments);
    return text;
}

/// Half a minute of work.
constexpr long defaultMoves = 1'000'000'000;
constexpr long mostMoves = 1'000'000'000'000'000;

/// Foreseen, because moved waves take the square of the segments.
void checkWork(const Arguments& arguments, const std::vector<int>& ladder) {
    const long limit = arguments.number("work-limit", defaultMoves, 1, mostMoves);
    const double moves = latticeMoves(ladder);
    if (moves <= static_cast<double>(limit)) return;
    throw CommandError(
        ExitCode::usage,
        Message(translatable("--segments %1: would move waves by %2 segments, more than --work-limit, now "
                             "%3, permits (half a minute is some 1e9); take fewer or permit more"),
                {segmentsText(ladder), arguments.style().number(moves, 2), std::to_string(limit)}));
}

ExitCode runAccuracy(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    arguments.checkOnePrinted();
    checkAboutFiles(arguments, {"decimal-comma"}, "DIR");
    const std::vector<int> ladder = ladderOf(arguments);
    const std::string directory = arguments.value("o").value_or(std::string());
    const StudyPlots plots = StudyPlots::inFolder(arguments, "accuracy");
    const ScenarioDocument document = loadScenarioInput(path, arguments).document;
    const bool inFolder = !directory.empty() && directory != "-";
    if (inFolder) {
        checkOutputIsNoInput(directory + "/" + accuracyCsvName, arguments, document);
        checkFolder(directory, plots.namesWith({accuracyCsvName}), overwrite);
        plots.check(arguments, document, overwrite);
    }

    if (!isFollowedByEvents(document.scenario) && arguments.has("segments"))
        throw CommandError(ExitCode::usage, about("--segments", forUniformRods(path)));
    if (isFollowedByEvents(document.scenario)) checkWork(arguments, ladder);
    checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    ShareBar bar(arguments.style());
    const StudyAnswerPtr answer =
        studyAccuracy(document.scenario, ladder, {.stop = interruption.token(), .progress = bar.progress()});
    interruption.check();
    if (const Message gap = answer->gap(); !gap.isEmpty())
        throw CommandError(ExitCode::unsolvedOrFailed, about(path, gap));
    const std::string scenarioText = completeScenarioText(document);
    const std::string csv = scenarioHeader(scenarioText) + answer->csv(OutputUnits::dimensionless);
    if (directory == "-") {
        printText(inCsvSigns(csv));
        return ExitCode::done;
    }
    if (inFolder) {
        FolderFiles folder{plots.draw(answer.get(), drawing, interruption),
                           [](const std::string& there) { return studyFilesThere(there, accuracyCsvName); }};
        folder.files.push_back({accuracyCsvName, csv});
        writeFolder(directory, folder, overwrite, &interruption);
    }
    printText(arguments.has("json") ? answer->json(scenarioText) : answer->text(arguments.style()));
    return ExitCode::done;
}

}  // namespace

const Command& accuracyCommand() {
    static const Command command{
        .name = "accuracy",
        .operands = "FILE",
        .summary = "compare error and run time of every method and resolution",
        .details =
            "Solves the blow exactly, in closed form if it applies, and numerically with the rod divided "
            "into\n100 to 20000 segments (lattice). Compares errors and run times, which takes some ten "
            "seconds. For\ndrill strings, compares the solver of this program at several cell sizes with a "
            "lattice of\nconstant cells.",
        .options = scenarioOptions(
            {{"segments", "A,B,C",
              "numbers of rod segments to compare in the lattice method (time steps), such as 100,1000 "
              "(default: from 100 to 20000)"},
             {"work-limit", "N",
              "limit the work of the lattice method, counted as time steps times segments (default: "
              "1000000000, about half a minute)"},
             {"json", "", "print one JSON object instead of the table"},
             {"o", "DIR",
              "also write the table to accuracy.csv in DIR; -o - prints this CSV instead of the table"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runAccuracy,
    };
    return command;
}

}  // namespace drillwave
