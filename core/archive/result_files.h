// SPDX-License-Identifier: GPL-3.0-or-later
// The files of results: of one blow, beside the rows of a study, of a report, and their pictures.
#pragma once

#include <array>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/blow.h"
#include "core/disk/whole_folder.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

// Formats in which pictures are written, and orders for pictures.

/// File extensions of the formats.
inline constexpr std::array<std::string_view, 3> pictureFormats{"png", "svg", "pdf"};

/// Marks in the properties of pictures beside the file of a study, of figures of the paper, and of reports:
/// with the names, a later run recognises files of an earlier one by these.
inline constexpr std::string_view studyPictureMark = "Drillwave study";
inline constexpr std::string_view figureMark = "Drillwave figure";
inline constexpr std::string_view reportMark = "Drillwave report";

/// Pictures to be drawn of one thing.
struct PictureOrder {
    std::string stem;                  ///< of their names: "t38" for t38.png
    std::vector<std::string> formats;  ///< of pictureFormats
    std::stop_token stop;              ///< ends the drawing between two pictures
    std::string mark = "Drillwave";    ///< creator, in their properties
};

// Files of one blow, as written by `drillwave run -o` and by the export of the window.

/// Blow with additional data for its files.
struct SolvedRun {
    Blow blow;                 ///< solved with Detail::histories
    std::string scenarioText;  ///< gives its scenario again (completeScenarioText())
    OutputUnits units = OutputUnits::dimensionless;
};

/// Returns the default units for the files of a run: SI if the scenario has
/// units.
OutputUnits customaryUnits(const Scenario& scenario);

/// Returns the lines at the top of every CSV file: the whole scenario and how it was solved.
std::string runHeader(const SolvedRun& run);

/// histories.csv: the header with the whole scenario, then the curves; of a string with those in the middle
/// of its longest section. Requires Impact::hasHistories().
std::string historiesFile(const SolvedRun& run);

/// Returns events.csv in the same way.
std::string eventsFile(const SolvedRun& run);

/// scenario.yaml: the scenario that was solved, complete in itself, behind who solved it and how.
std::string scenarioFile(const SolvedRun& run);

/// Returns the names of the files of a run with pictures in these formats.
std::vector<std::string> runFileNames(const std::vector<std::string>& formats);

/// Returns those files of a run, with pictures in every format, that exist in the folder.
std::vector<std::string> runFilesThere(const std::string& folder);

/// Name of the record of gauges in the folder of a run (core/report/gauge_record.h).
inline constexpr char gaugeRecordName[] = "record.csv";

/// Returns the folder of a run, with further files: pictures, a record of gauges. Pictures of an earlier run
/// in formats not requested would show another blow and are removed. A folder with a summary.json is
/// complete. The same run gives the same bytes wherever it is written from, except `run_time` in summary.json
/// and the creation date in PDF.
FolderFiles runFolder(const SolvedRun& run, std::vector<NamedFile> further);

// Files that belong together: those beside the rows of a study, and the two files of a report.

/// "map" of "map.csv", to which pictures and contours append; another ending stays.
std::string studyStem(std::string_view file);

/// "map.csv.yaml" of "map.csv", with the folder that `file` has.
std::string recordName(std::string_view file);

/// "map_contours.csv" of "map.csv".
std::string contoursName(std::string_view file);

/// "curve_goal.csv" of "curve.csv".
std::string goalName(std::string_view file);

/// Returns the names of files in the folder beside FILE that an earlier study wrote, by name and content: its
/// record, contours, goal and pictures. Other files with such a name are not touched.
std::vector<std::string> studyFilesThere(const std::string& folder, const std::string& file);

/// Returns the names of the pictures STEM.png, .svg and .pdf in the folder with `mark` in their properties.
std::vector<std::string> picturesThere(const std::string& folder, const std::string& stem,
                                       std::string_view mark);

/// Where FILE is there, the other file of the report that it is of: report.pdf beside report.html.
std::vector<std::string> reportFilesThere(const std::string& folder, const std::string& file);

}  // namespace drillwave
