// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave design FILE --uncertain KEY=LOW:HIGH --choose KEY=…
#include <algorithm>
#include <iterator>

#include "app/axis_argument.h"
#include "app/command.h"
#include "app/design_options.h"
#include "app/design_run.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_files.h"
#include "core/archive/result_scenario.h"
#include "core/numeric/run_time.h"
#include "core/report/design_report.h"

namespace drillwave {

namespace {

constexpr const char* jsonName = "design.json";
constexpr const char* pictureOwner = "design.csv";  // whose pictures would be design.png …
const std::vector<std::string> fileNames{"designs.csv", "pareto.csv", "sensitivity.csv",
                                         "worst.csv",   "best.yaml",  jsonName};

/// The one operand that is no further word of --aim.
const std::string& fileOf(const Arguments& arguments) {
    const std::string* file = nullptr;
    for (const std::string& word : arguments.operands()) {
        if (isAimWord(word)) continue;
        if (file)
            throw CommandError(ExitCode::usage, Message(translatable("takes one FILE; remove `%1`"), {word}));
        file = &word;
    }
    if (!file) throw CommandError(ExitCode::usage, translatable("needs FILE"));
    return *file;
}

FolderFiles filesOf(const DesignReport& report, ScenarioDocument document, std::vector<NamedFile> pictures) {
    document.scenario = designScenario(report.study, *report.findings.best.robust);
    std::vector<NamedFile> files{{"designs.csv", designsCsv(report)},
                                 {"pareto.csv", paretoCsv(report)},
                                 {"sensitivity.csv", sensitivityCsv(report)},
                                 {"worst.csv", worstCsv(report)},
                                 {"best.yaml", completeScenarioText(std::move(document))},
                                 {jsonName, designJson(report)}};
    std::ranges::move(pictures, std::back_inserter(files));
    return {.files = std::move(files),
            .outdated = [](const std::string& there) { return studyFilesThere(there, pictureOwner); }};
}

/// Prints that samples are taken in powers of two, if another number was given.
void remarkOnSamples(const Arguments& arguments, std::uint64_t taken) {
    const std::optional<std::string> asked = arguments.value("samples");
    if (asked && *asked != std::to_string(taken))
        printRemark(
            {translatable("--samples %1: rounded up to %2, a power of two"), {*asked, std::to_string(taken)}},
            arguments.style());
}

ExitCode runDesignCommand(const Arguments& arguments, const Drawing* drawing) {
    const std::string path = fileOf(arguments);
    const std::optional<std::string> folder = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    checkAboutFiles(arguments, {"force", "decimal-comma"}, "DIR");
    if (folder == "-")
        throw CommandError(ExitCode::usage,
                           translatable("-o - names no folder for the files; add -o DIR, or --json, which "
                                        "prints to standard output"));
    if (arguments.values("draws").size() > 1)
        throw CommandError(ExitCode::usage, Message(translatable("%1 is given twice; give it once"),
                                                    {std::string("--draws")}));
    const int jobs = jobsOf(arguments);
    const StudyPlots plots = StudyPlots::inFolder(arguments, "design");
    const ScenarioDocument document = loadScenarioArgument(path, arguments);
    DesignFaults faults;
    DesignReport report{.study = designStudyOf(arguments, document.scenario, document.design, faults),
                        .findings = {},
                        .scenarioText = {}};
    faults.check();
    std::vector<std::string> words;
    const std::vector<std::string> choices =
        arguments.has("choose") ? arguments.values("choose") : document.design.choose;
    for (const std::string& word : choices) words.push_back(quotedAxis("choose", word));
    checkNotSet(arguments, document.scenario, report.study.choices, words);
    report.scenarioText = completeScenarioText(document);
    if (folder) {
        for (const std::string& name : fileNames)
            checkOutputIsNoInput(*folder + "/" + name, arguments, document);
        checkFolder(*folder, plots.namesWith(fileNames), overwrite);
        plots.check(arguments, document, overwrite);
    }

    checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    remarkOnSamples(arguments, report.study.samples);
    const Stopwatch watch;
    report.findings = findDesigns(report.study, {jobs, path, arguments.style()}, interruption);
    report.runTime = watch.seconds();
    if (folder)
        writeFolder(*folder, filesOf(report, document, plots.draw(&report, drawing, interruption)), overwrite,
                    &interruption);
    std::string text = arguments.has("json") ? designJson(report) : designText(report, arguments.style());
    if (folder && !arguments.has("json"))
        text += "  " + arguments.style().said({translatable("files in %1"), {*folder}}) + "\n";
    printText(text);
    return ExitCode::done;
}

}  // namespace

const Command& designCommand() {
    using Times = OptionSpec::Times;
    static constexpr std::string_view details =
        "Solves every design (every combination of the --choose values) with the same samples of "
        "the\nuncertain inputs. Prints the best design over all samples (best for uncertain rock) and "
        "the\nbest with the inputs of FILE (best for the values entered). The first --aim decides both. "
        "Also\nprints which designs are equally good within the errors, which input to measure first, and "
        "the\nworst case in the ranges. The first sentence warns if the recommended design exceeds "
        "a\nstrength.\n  --uncertain KEY=LOW:HIGH   all values from LOW to HIGH equally likely; with :log, "
        "equally likely\n                             on a logarithmic scale. With :normal or :lognormal, a "
        "normal or\n                             lognormal distribution with 95 % of the values from LOW to "
        "HIGH\n  --uncertain KEY=+-P%       P % to either side of the value in FILE, or of the --choose "
        "value\n  --choose hammer=NAME,NAME  hammer presets by name, or hammer=all for all of them; rod= "
        "works in the\n                             same way. For drill strings, hammer= takes pistons, and "
        "bit= takes bits\nA STATISTIC is mean, q01 to q99 (quantiles), min, max or nominal (with the inputs "
        "of FILE).\nWithout --aim, the objectives are max:efficiency@q05 and, if FILE has a blow "
        "frequency,\nmin:thrust@q95. Options that are not given are taken from the block `design` of FILE. "
        "-o DIR\nwrites designs.csv, pareto.csv, sensitivity.csv, worst.csv, best.yaml, design.json and, "
        "with\n--plots, design.png.";
    static const Command command{
        .name = "design",
        .operands = "FILE",
        .summary = "find the best design for uncertain inputs, and which input to measure",
        .details = details,
        .furtherHelp = outputHelp,
        .options = scenarioOptions(
            {{"uncertain", "KEY=LOW:HIGH",
              "uncertain input and the range of its values; see the description of the command", Times::list},
             {"draws", "FILE.csv",
              "take the samples of uncertain inputs from this table, one per row; its header names "
              "parameters",
              Times::repeated},
             {"choose", "KEY=VALUES",
              "design variable to vary; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or "
              "A,B,C; to compare presets: hammer=NAME,NAME",
              Times::list},
             {"aim", "max:OUTPUT@STATISTIC",
              "statistic of an output to maximise, or with min:… to minimise; up to three; the designs are "
              "ranked by the first",
              Times::repeated},
             {"at-most", "OUTPUT@STATISTIC=VALUE",
              "limit: accept only designs for which this statistic of the output is at most VALUE",
              Times::list},
             {"at-least", "OUTPUT@STATISTIC=VALUE",
              "limit: accept only designs for which this statistic of the output is at least VALUE",
              Times::list},
             {"keep-energy", "",
              "give every design the blow energy of FILE, by scaling its impulse or hammer velocity"},
             {"no-keep-energy", "",
              "compare each design at its own blow energy, even if FILE sets keep_energy (the same energy "
              "for all designs)"},
             {"samples", "N",
              "number of random samples for each design, rounded up to a power of two (default: 4096, for a "
              "drill string 1024)"},
             {"seed", "S", "seed of the random samples (default: 1)"},
             {"j", "N", "number of threads (default: all)"},
             workLimitSpec(),
             {"json", "", "print one JSON object instead of the tables"},
             {"o", "DIR",
              "also write the tables, the scenario of the best design and the JSON object into DIR"},
             plotsOptionSpec(),
             {"force", "", "overwrite existing files"},
             decimalCommaSpec()}),
        .leastOperands = 1,
        .mostOperands = mostAims + 2,
        .draws = asksForPlots,
        .run = runDesignCommand,
    };
    return command;
}

}  // namespace drillwave
