// SPDX-License-Identifier: GPL-3.0-or-later
// Files of results: of one blow, next to the rows of a study, of a report, and their pictures.
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

// Formats of pictures, and orders for pictures.

/// File extensions of the picture formats.
inline constexpr std::array<std::string_view, 3> pictureFormats{"png", "svg", "pdf"};

/// Creator that the program writes into the properties of a picture: of a study, of a figure of the paper, or
/// of a report. By this text, a later run recognises pictures that it may replace.
inline constexpr std::string_view studyPictureMark = "Drillwave study";
inline constexpr std::string_view figureMark = "Drillwave figure";
inline constexpr std::string_view reportMark = "Drillwave report";

/// Request for pictures of one result: file names, formats and stop token.
struct PictureOrder {
    std::string stem;                  ///< beginning of their file names: "t38" for t38.png
    std::vector<std::string> formats;  ///< picture formats, such as "png", from pictureFormats
    std::stop_token stop;              ///< request to stop, checked between two pictures
    std::string mark = "Drillwave";    ///< creator that is written into the properties of the pictures
};

// Files of one blow, as written by `drillwave run -o` and by the export of the window.

/// Solved blow, with everything else that the files of its results contain.
struct SolvedRun {
    Blow blow;                 ///< blow, solved with Detail::histories
    std::string scenarioText;  ///< complete text of the scenario of the blow (completeScenarioText())
    OutputUnits units = OutputUnits::dimensionless;
};

/// Returns the default units for the files of a run: SI if the scenario has units, else dimensionless.
OutputUnits customaryUnits(const Scenario& scenario);

/// Returns the lines at the top of every CSV file of a run: the entire scenario, and how it was solved.
std::string runHeader(const SolvedRun& run);

/// Returns the text of histories.csv: a header with the entire scenario, then the histories over time. For a
/// drill string these include the middle of its longest section. Requires Impact::hasHistories().
std::string historiesFile(const SolvedRun& run);

/// Returns the text of events.csv: a header with the entire scenario, then the contact events of the blow
/// with their times.
std::string eventsFile(const SolvedRun& run);

/// Returns the text of scenario.yaml: the program and the method that solved the scenario, and the complete
/// scenario.
std::string scenarioFile(const SolvedRun& run);

/// Returns the names of all files of a run, with pictures in these formats.
std::vector<std::string> runFileNames(const std::vector<std::string>& formats);

/// Returns the names of existing files in the folder that a run may have written, such as "summary.json".
/// Pictures in all formats are included.
std::vector<std::string> runFilesThere(const std::string& folder);

/// Name of the file with the record of strain gauges in the folder of a run (core/report/gauge_record.h).
inline constexpr char gaugeRecordName[] = "record.csv";

/// Returns the files to be written for a run, together with `further` ones, such as pictures or a record of
/// gauges. Pictures of an earlier run in the same folder are removed, as they show another blow. The file
/// summary.json is written last: a folder that contains it is complete. The same run always gives the same
/// bytes, except `run_time` in summary.json and the creation date in PDF.
FolderFiles runFolder(const SolvedRun& run, std::vector<NamedFile> further);

// Files that belong together: those next to the rows of a study, and the two files of a report.

/// Returns the common beginning of the names of the pictures and contours beside a CSV file: "map" for
/// "map.csv". Other endings than ".csv" are not removed.
std::string studyStem(std::string_view file);

/// Returns the name of the YAML file (record) that describes a CSV file of rows, in the same folder:
/// "map.csv.yaml" for "map.csv".
std::string recordName(std::string_view file);

/// Returns the name of the file of contours of a map: "map_contours.csv" for "map.csv".
std::string contoursName(std::string_view file);

/// Returns the name of the file with the parameter values at which a curve reaches a goal: "curve_goal.csv"
/// for "curve.csv".
std::string goalName(std::string_view file);

/// Returns the names of files next to the CSV file `file` that an earlier study wrote: YAML record, contours
/// of a map, curve values for a goal, and pictures. They are recognised by name and content, so that other
/// files with such a name are not listed.
std::vector<std::string> studyFilesThere(const std::string& folder, const std::string& file);

/// Returns the names of the pictures STEM.png, STEM.svg and STEM.pdf in the folder that this program has
/// written: their properties contain `mark`.
std::vector<std::string> picturesThere(const std::string& folder, const std::string& stem,
                                       std::string_view mark);

/// Returns the other file of a report: report.pdf for report.html, and the reverse. Empty if `file` or the
/// other file does not exist, or if the other file is not from a report.
std::vector<std::string> reportFilesThere(const std::string& folder, const std::string& file);

}  // namespace drillwave
