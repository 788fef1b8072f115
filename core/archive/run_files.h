// SPDX-License-Identifier: GPL-3.0-or-later
// The files of one blow: what `drillwave run -o` and the window's export write, in one place.
#pragma once

#include <string>
#include <vector>

#include "core/blow/blow.h"
#include "core/disk/whole_folder.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// A blow with what its files say beside it.
struct SolvedRun {
    Blow blow;                 ///< solved with Detail::histories
    std::string scenarioText;  ///< gives its scenario again (completeScenarioText())
    OutputUnits units = OutputUnits::dimensionless;
};

/// Those in which the files of a run are written where nothing else is asked for: SI where the scenario has
/// units.
OutputUnits customaryUnits(const Scenario& scenario);

/// The lines at the top of every CSV file: the whole scenario and how it was solved.
std::string runHeader(const SolvedRun& run);

/// histories.csv: the header with the whole scenario, then the curves; of a string with those in the middle
/// of its longest section. Requires Impact::hasHistories().
std::string historiesFile(const SolvedRun& run);

/// events.csv, likewise.
std::string eventsFile(const SolvedRun& run);

/// scenario.yaml: the scenario that was solved, complete in itself, behind who solved it and how.
std::string scenarioFile(const SolvedRun& run);

/// The names of the files of a run with pictures in these formats.
std::vector<std::string> runFileNames(const std::vector<std::string>& formats);

/// Those of a run with pictures in every format that are in the folder already.
std::vector<std::string> runFilesThere(const std::string& folder);

/// The folder of a run, with pictures of it. Those that an earlier run left there in formats not asked for
/// would show another blow and are removed. A folder with a summary.json is complete. The same run gives the
/// same bytes wherever it is written from, but for `run_time` in summary.json and the creation date in PDF.
FolderFiles runFolder(const SolvedRun& run, std::vector<NamedFile> pictures);

}  // namespace drillwave
