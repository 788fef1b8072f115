// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave identify FILE --signals REC.csv --gauge COLUMN@DISTANCE
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/command.h"
#include "app/identify_options.h"
#include "app/input_text.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/identified_document.h"
#include "core/archive/result_scenario.h"
#include "core/report/identify_report.h"

namespace drillwave {

namespace {

constexpr const char* identifyJsonName = "identify.json";

FolderFiles identifyFolder(const IdentifyReport& report, std::vector<NamedFile> pictures) {
    std::vector<NamedFile> files{{"match.csv", matchCsv(report)},
                                 {"force_penetration.csv", forcePenetrationCsv(report)},
                                 {"incident.csv", incidentCsv(report)}};
    if (report.findings.records.size() > 1) files.push_back({"records.csv", recordsCsv(report)});
    if (std::string draws = posteriorCsv(report); !draws.empty())
        files.push_back({"posterior.csv", std::move(draws)});
    if (report.findings.saysSomething()) files.push_back({"identified.yaml", report.identifiedText});
    std::move(pictures.begin(), pictures.end(), std::back_inserter(files));
    files.push_back({identifyJsonName, identifyJson(report)});
    // Files of an earlier set that this one does not have would show something else.
    std::vector<std::string> absent;
    for (const char* name : {"records.csv", "posterior.csv", "identified.yaml"})
        if (std::none_of(files.begin(), files.end(),
                         [&](const NamedFile& file) { return file.name == name; }))
            absent.emplace_back(name);
    return {.files = std::move(files), .outdated = [absent](const std::string&) { return absent; }};
}

/// Throws where no record can be used at all.
void checkRefusals(const IdentifyFindings& findings) {
    std::vector<Message> lines;
    for (const RecordAnswer& record : findings.records) {
        if (!record.refusal) return;
        lines.push_back(about(record.file, record.refusal->text));
    }
    throw CommandError(ExitCode::unreadableInput, lines);
}

ExitCode runIdentifyCommand(const Arguments& arguments, const Drawing* drawing) {
    const IdentifyFiles files = identifyFiles(arguments);
    const std::optional<std::string> folder = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    checkAboutFiles(arguments, {"force", "decimal-comma"}, "DIR");
    if (folder == "-")
        throw CommandError(ExitCode::usage,
                           translatable("-o - names no folder for the files; add -o DIR, or --json, "
                                        "which prints to standard output"));
    const StudyPlots plots = StudyPlots::inFolder(arguments, "match");
    const int jobs = jobsOf(arguments);
    const ScenarioDocument document = loadScenarioArgument(files.scenario, arguments);
    if (folder) {
        const std::vector<std::string> names =
            plots.namesWith({"match.csv", "force_penetration.csv", "incident.csv", "records.csv",
                             "posterior.csv", "identified.yaml", identifyJsonName});
        std::vector<std::string> inputs = files.records;
        inputs.push_back(files.scenario);
        for (const std::string& name : names) checkNotInputFile(*folder + "/" + name, inputs);
        checkFolder(*folder, names, overwrite);
    }
    checkStandardOutput();
    const Interruption interruption;
    IdentifyReport report{
        identifyQuestionOf(arguments, document.scenario, files.scenario, files.records, interruption.token()),
        {},
        completeScenarioText(document),
        {}};
    interruption.check();
    ProgressBar bar(report.question.records.size(), translatable("records"), arguments.style());
    report.findings =
        runIdentify(report.question, jobs, interruption.token(), [&](const IdentifyFindings& done) {
            bar.show(std::min(done.records.size(), report.question.records.size()));
        });
    interruption.check();
    checkRefusals(report.findings);
    for (const RecordAnswer& record : report.findings.records)
        if (record.refusal) printRemark(about(record.file, record.refusal->text), arguments.style());
    report.identifiedText = identifiedDocument(report, document).text;
    if (folder)
        writeFolder(*folder, identifyFolder(report, plots.draw(&report, drawing, interruption)), overwrite,
                    &interruption);
    std::string text = arguments.has("json") ? identifyJson(report) : identifyText(report, arguments.style());
    if (folder && !arguments.has("json"))
        text += "  " + arguments.style().said({translatable("files in %1"), {*folder}}) + "\n";
    printText(text);
    return report.findings.saysSomething() ? ExitCode::done : ExitCode::unsolvedOrFailed;
}

}  // namespace

const Command& identifyCommand() {
    static constexpr std::string_view details =
        "Finds stiffness and elasticity (gamma) of the rock, and the gap between bit and rock. Uses "
        "the\nwaves recorded by strain gauges on the rod, or on the last rod of a string. Prints the "
        "values\nwith their 95 % intervals, what limits their accuracy, and what to measure better. The rock "
        "of\nFILE (bit_rock) is used only with --law file. --known KEY=+-TOL states how well the inputs "
        "are\nknown:\n  --known gain=+-5% zero=+-1%   gain of the amplifier, and its zero line in % of the "
        "peak\n  --known gauge=+-2mm           distance of the gauges from the bit face\n  --known "
        "rod.diameter=+-0.1mm  a dimension of the section with the gauge, or of a section between\n          "
        "                      gauge and bit\nRecords are read with the options of `signal`. -o DIR writes "
        "identified.yaml, posterior.csv\n(random samples of the rock for design --draws), match.csv, "
        "force_penetration.csv, incident.csv,\nidentify.json and, for several records, records.csv. Exit "
        "code 0: stiffness or gamma is known.\nExit code 6: neither is known, or the record contradicts the "
        "model. The intervals can be too\nnarrow if the loading or the unloading curve of the rock is not a "
        "straight line (commands\n§4.17).";
    static const Command command{
        .name = "identify",
        .operands = "FILE",
        .summary = "find stiffness and elasticity of the rock from strain gauges, with uncertainty",
        .details = details,
        .options = identifyOptionSpecs(),
        .leastOperands = 1,
        .mostOperands = SIZE_MAX,
        .draws = asksForPlots,
        .run = runIdentifyCommand,
    };
    return command;
}

}  // namespace drillwave
