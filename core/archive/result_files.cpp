// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/result_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "core/archive/row_record.h"
#include "core/blow/blow.h"
#include "core/disk/file_bytes.h"
#include "core/disk/whole_folder.h"
#include "core/report/blow_csv.h"
#include "core/report/blow_json.h"
#include "core/report/goal_report.h"
#include "core/report/map_report.h"
#include "core/report/report_html.h"
#include "core/report/result_remarks.h"

namespace drillwave {

namespace {

constexpr char scenarioName[] = "scenario.yaml";
constexpr char summaryName[] = "summary.json";
constexpr char historiesName[] = "histories.csv";
constexpr char eventsName[] = "events.csv";

/// Returns whether the folder holds a run; files of the same names that are no run's are not touched.
bool holdsRun(const std::string& folder) {
    return readStart(folder + "/" + historiesName, csvRemarksBegin.size()).bytes == csvRemarksBegin;
}

/// Returns the files to remove: in other formats, pictures of an earlier run would stay with the new numbers.
std::vector<std::string> filesOfEarlierRun(const std::string& folder) {
    return holdsRun(folder) ? runFilesThere(folder) : std::vector<std::string>();
}

constexpr std::string_view rowsEnding = ".csv";
constexpr std::size_t startBytes = 8192;  // PNG, SVG and PDF say within these who made them

std::string startOf(const std::string& path) {
    return readStart(path, startBytes).bytes;
}

/// PDF has its words in UTF-16.
std::string inTwoBytes(std::string_view ascii) {
    std::string text;
    for (const char c : ascii) {
        text += '\0';
        text += c;
    }
    return text;
}

bool bears(const std::string& path, std::string_view mark) {
    const std::string start = startOf(path);
    return start.find(mark) != std::string::npos || start.find(inTwoBytes(mark)) != std::string::npos;
}

/// Returns whether CSV begins with these headers, whatever its separator is.
bool beginsAs(const std::string& path, std::string_view headers) {
    std::string start = startOf(path).substr(0, headers.size());
    std::ranges::replace(start, ';', ',');
    return start == headers;
}

bool isReportPage(const std::string& path) {
    return !reportRecord(startOf(path)).empty();
}

}  // namespace

OutputUnits customaryUnits(const Scenario& scenario) {
    return hasUnits(scenario) ? OutputUnits::si : OutputUnits::dimensionless;
}

std::string runHeader(const SolvedRun& run) {
    return scenarioHeader(run.scenarioText, solverWords(run.blow).remark);
}

std::string historiesFile(const SolvedRun& run) {
    const Blow& blow = run.blow;
    const StringPlace place = middleOfLongest(blow.scenario.drillString);
    return scenarioHeader(run.scenarioText, solverWords(blow).remark,
                          historyColumns(blow.scenario, place, run.units)) +
           historiesCsv(blow, place, run.units);
}

std::string eventsFile(const SolvedRun& run) {
    return runHeader(run) + eventsCsv(run.blow.impact, run.units, run.blow.scales);
}

std::string scenarioFile(const SolvedRun& run) {
    return remarksText(".", solverWords(run.blow).remark) + run.scenarioText;
}

std::vector<std::string> runFileNames(const std::vector<std::string>& formats) {
    std::vector<std::string> names{scenarioName, summaryName, historiesName, eventsName, gaugeRecordName};
    for (const std::string& format : formats) {
        for (const char* plot : {"blow.", "rock.", "wave_picture.", "rod."}) names.push_back(plot + format);
    }
    return names;
}

std::vector<std::string> runFilesThere(const std::string& folder) {
    std::vector<std::string> names = runFileNames({pictureFormats.begin(), pictureFormats.end()});
    std::erase_if(names, [&](const std::string& name) { return !isThere(folder + "/" + name); });
    return names;
}

FolderFiles runFolder(const SolvedRun& run, std::vector<NamedFile> further) {
    FolderFiles folder;
    folder.outdated = filesOfEarlierRun;
    folder.files = {{scenarioName, scenarioFile(run)}, {eventsName, eventsFile(run)}};
    if (run.blow.impact.hasHistories()) folder.files.push_back({historiesName, historiesFile(run)});
    std::ranges::move(further, std::back_inserter(folder.files));
    folder.files.push_back({summaryName, blowJson(run.blow, run.scenarioText)});
    return folder;
}

std::string studyStem(std::string_view file) {
    if (file.size() > rowsEnding.size() && file.ends_with(rowsEnding)) file.remove_suffix(rowsEnding.size());
    return std::string(file);
}

std::string recordName(std::string_view file) {
    return std::string(file) + ".yaml";
}

std::string contoursName(std::string_view file) {
    return studyStem(file) + "_contours.csv";
}

std::string goalName(std::string_view file) {
    return studyStem(file) + "_goal.csv";
}

std::vector<std::string> studyFilesThere(const std::string& folder, const std::string& file) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const auto& isOurs) {
        const std::string path = pathInside(folder, name);
        if (isThere(path) && isOurs(path)) names.push_back(name);
    };
    add(recordName(file), [](const std::string& path) { return startOf(path).starts_with(rowRecordKey); });
    add(contoursName(file), [](const std::string& path) { return beginsAs(path, contoursCsvBegin); });
    add(goalName(file), [](const std::string& path) { return beginsAs(path, goalCsvBegin); });
    const std::vector<std::string> pictures = picturesThere(folder, studyStem(file), studyPictureMark);
    names.insert(names.end(), pictures.begin(), pictures.end());
    return names;
}

std::vector<std::string> picturesThere(const std::string& folder, const std::string& stem,
                                       std::string_view mark) {
    std::vector<std::string> names;
    for (const std::string_view format : pictureFormats) {
        const std::string name = stem + "." + std::string(format);
        const std::string path = pathInside(folder, name);
        if (isThere(path) && bears(path, mark)) names.push_back(name);
    }
    return names;
}

std::vector<std::string> reportFilesThere(const std::string& folder, const std::string& file) {
    if (!isThere(pathInside(folder, file))) return {};
    const std::string stem = std::filesystem::path(file).stem();
    const bool isPage = std::filesystem::path(file).extension() != ".pdf";
    const std::string other = stem + (isPage ? ".pdf" : ".html");
    const std::string path = pathInside(folder, other);
    if (!isThere(path)) return {};
    const bool isOurs = isPage ? bears(path, reportMark) : isReportPage(path);
    return isOurs ? std::vector{other} : std::vector<std::string>();
}

}  // namespace drillwave
