// SPDX-License-Identifier: GPL-3.0-or-later
// The files that belong together: what stands beside the rows of a study, and the two files of a report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// "map" of "map.csv", to which pictures and contours append; another ending stays.
std::string studyStem(std::string_view file);

/// "map.csv.yaml" of "map.csv", with the folder that `file` has.
std::string recordName(std::string_view file);

/// "map_contours.csv" of "map.csv".
std::string contoursName(std::string_view file);

/// "curve_goal.csv" of "curve.csv".
std::string goalName(std::string_view file);

/// The names of what stands in the folder beside FILE and is an earlier study's, by name and content: its
/// record, contours, goal and pictures. Whatever else has such a name is left alone.
std::vector<std::string> studyFilesThere(const std::string& folder, const std::string& file);

/// The names of the pictures STEM.png, .svg and .pdf in the folder that say `mark` of themselves.
std::vector<std::string> picturesThere(const std::string& folder, const std::string& stem,
                                       std::string_view mark);

/// Where FILE is there, the other file of the report that it is of: report.pdf beside report.html.
std::vector<std::string> reportFilesThere(const std::string& folder, const std::string& file);

}  // namespace drillwave
