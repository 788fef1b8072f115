// SPDX-License-Identifier: GPL-3.0-or-later
// `drillwave report`: a blow as a page to hand over.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command.h"
#include "app/interruption.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "app/report_studies.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/archive/report_file.h"
#include "core/archive/result_files.h"
#include "core/report/report_html.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

constexpr std::string_view stem = "report";  // of the files in a folder
constexpr std::string_view withoutPlots = "no-plots";

/// Files requested by -o.
struct ReportPlace {
    std::string path;  ///< "-": HTML on standard output
    bool isFolder = false;
    std::vector<std::string> formats;

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const std::string& format : formats) names.push_back(std::string(stem) + "." + format);
        return names;
    }
    /// The files, with their folder.
    std::vector<std::string> paths() const {
        if (!isFolder) return {path};
        std::vector<std::string> paths;
        for (const std::string& name : names()) paths.push_back(path + "/" + name);
        return paths;
    }
};

/// A name that ends like that of a file and is none of a report is most likely mistaken.
ReportPlace placeOf(const Arguments& arguments) {
    const std::optional<std::string> path = arguments.value("o");
    if (!path)
        throw CommandError(ExitCode::usage,
                           translatable("needs -o DIR, -o FILE.html or -o FILE.pdf, where to write"));
    if (isStream(*path)) return {*path, false, {"html"}};
    std::error_code ignored;
    std::string ending = std::filesystem::path(*path).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool hasPlots = !arguments.has(withoutPlots);
    if (ending == ".pdf" && !hasPlots)
        throw CommandError(ExitCode::usage,
                           translatable("--no-plots: a PDF is drawn with its plots; give -o FILE.html"));
    if (ending == ".html" || ending == ".pdf") return {*path, false, {ending.substr(1)}};
    const bool isFolder = path->ends_with('/') || std::filesystem::is_directory(*path, ignored);
    if (!ending.empty() && !isFolder)
        throw CommandError(
            ExitCode::usage,
            about(
                "-o " + *path,
                translatable("a report is FILE.html or FILE.pdf; for a folder of that name, end it with /")));
    if (!hasPlots) return {*path, true, {"html"}};
    return {*path, true, {"html", "pdf"}};
}

/// Finds out before anything is computed whether the files can be written.
void check(const ReportPlace& place, const Arguments& arguments, const ScenarioDocument& document,
           Overwrite overwrite) {
    for (const std::string& path : place.paths()) checkOutputIsNoInput(path, arguments, document);
    if (place.isFolder)
        checkFolder(place.path, place.names(), overwrite);
    else
        checkOutput(place.path, overwrite, reportFilesThere);
}

BlowReport study(const ScenarioDocument& document, const WorkLimits& limits, const ReadingStyle& style,
                 const Interruption& interruption) {
    ShareBar bar(style);
    BlowReport report = reportOn(document, interruption.token(), bar.progress(), limits);
    interruption.check();
    return report;
}

void write(const ReportPlace& place, std::vector<NamedFile> files, Overwrite overwrite,
           const Interruption& interruption) {
    if (!place.isFolder) {
        OutputFile file(place.path, overwrite, reportFilesThere);
        file.writeText(files.front().bytes);
        return file.commit(&interruption);
    }
    FolderFiles folder;
    folder.files = std::move(files);
    // A page without plots comes without a PDF.
    folder.outdated = [&folder](const std::string& there) {
        return folder.files.size() > 1 ? std::vector<std::string>()
                                       : reportFilesThere(there, folder.files.front().name);
    };
    writeFolder(place.path, folder, overwrite, &interruption);
}

/// Returns the lines below the title. Throws CommandError (usage).
ReportHead headOf(const Arguments& arguments) {
    const auto text = [&](const char* option) {
        std::string words = arguments.value(option).value_or("");
        if (const Message problem = lineProblem(words); !problem.isEmpty())
            throw CommandError(ExitCode::usage, about("--" + std::string(option), problem));
        return words;
    };
    return {text("project"), text("author"), text("customer"), text("date")};
}

ExitCode runReport(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const ReportPlace place = placeOf(arguments);
    const ReportHead head = headOf(arguments);
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const ScenarioDocument document = loadScenarioArgument(path, arguments);
    const ReportStudyPlan studies(arguments, document, path);
    check(place, arguments, document, overwrite);

    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    BlowReport report = study(document, workLimitsOf(arguments), arguments.style(), interruption);
    report.head = head;
    if (!report.blow.isSolved())
        throw CommandError(
            ExitCode::unsolvedOrFailed,
            couldNotBeSolved(path, reasonWithHint(report.blow.impact.reason, arguments, document.scenario,
                                                  report.blow.impact.hindrance)));
    report.studies = studies.run(interruption);
    std::vector<NamedFile> files;
    if (drawing)
        files = drawing->report(report, {std::string(stem), place.formats, interruption.token()});
    else
        files.push_back(
            {place.names().front(), reportHtml(report, {}, ReportMedium::screen, arguments.style())});
    interruption.check();
    write(place, std::move(files), overwrite, interruption);
    if (!isStream(place.path))
        std::printf("%s\n", arguments.style().said({translatable("report in %1"), {place.path}}).c_str());
    return ExitCode::done;
}

}  // namespace

const Command& reportCommand() {
    static const Command command{
        .name = "report",
        .operands = "FILE",
        .summary = "write a report: inputs with sources, results, verdict, plots, scenario",
        .details =
            "FILE.html is a single file with inputs, results, pictures and the scenario. It can be run "
            "again:\n"
            "`drillwave run FILE.html`. FILE.pdf has the same content for printing on A4. -o DIR writes "
            "both,\n"
            "as report.html and report.pdf. The numbers are those of `run --json`, in SI if the scenario "
            "has\n"
            "physical units. The source of a value is the comment after it in the scenario file. For drill\n"
            "strings, the report also shows the sections, drawn to scale, with their largest stresses.",
        .options = scenarioOptions(
            {{"project", "TEXT", "name of the project, shown below the title"},
             {"author", "TEXT", "author"},
             {"customer", "TEXT", "customer"},
             {"date", "TEXT", "date printed in the report, any text (default: none)"},
             reportStudiesSpec(),
             {withoutPlots, "", "write no plots and no PDF; a display is then not needed"},
             {"j", "N", "number of processor threads for the studies added by --with (default: all)"},
             workLimitSpec(),
             {"o", "DIR|FILE.html|FILE.pdf", "file or folder to write the report to; -o - prints the HTML"},
             {"force", "", "overwrite existing files"}}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = [](const Arguments& arguments) { return !arguments.has(withoutPlots); },
        .run = runReport,
    };
    return command;
}

}  // namespace drillwave
