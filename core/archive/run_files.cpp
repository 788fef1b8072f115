// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/run_files.h"

#include <algorithm>
#include <iterator>

#include "core/archive/picture_formats.h"
#include "core/blow/solver_words.h"
#include "core/disk/file_bytes.h"
#include "core/report/blow_csv.h"
#include "core/report/blow_json.h"
#include "core/report/result_remarks.h"

namespace drillwave {
namespace {

constexpr char scenarioName[] = "scenario.yaml";
constexpr char summaryName[] = "summary.json";
constexpr char historiesName[] = "histories.csv";
constexpr char eventsName[] = "events.csv";

/// Files of these names that are no run's may be there too: those are left alone.
bool holdsRun(const std::string& folder) {
    return readStart(folder + "/" + historiesName, csvRemarksBegin.size()).bytes == csvRemarksBegin;
}

/// With other formats the pictures of an earlier run would stay beside the new numbers.
std::vector<std::string> filesOfEarlierRun(const std::string& folder) {
    return holdsRun(folder) ? runFilesThere(folder) : std::vector<std::string>();
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
    std::vector<std::string> names{scenarioName, summaryName, historiesName, eventsName};
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

FolderFiles runFolder(const SolvedRun& run, std::vector<NamedFile> pictures) {
    FolderFiles folder;
    folder.outdated = filesOfEarlierRun;
    folder.files = {{scenarioName, scenarioFile(run)}, {eventsName, eventsFile(run)}};
    if (run.blow.impact.hasHistories()) folder.files.push_back({historiesName, historiesFile(run)});
    std::ranges::move(pictures, std::back_inserter(folder.files));
    folder.files.push_back({summaryName, blowJson(run.blow, run.scenarioText)});
    return folder;
}

}  // namespace drillwave
