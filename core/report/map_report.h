// SPDX-License-Identifier: GPL-3.0-or-later
// A map with its contours, and all that is reported about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/map/contours.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Contents of the report of a map.
struct MapReport {
    MapStudy study;
    MapGrid grid;                   ///< values of the output at all points of the map
    std::vector<Contour> contours;  ///< contours, one for each requested level, in the order of the levels
    double runTime = 0;             ///< computing time [s]
    std::string scenarioText;       ///< scenario file that reproduces the base scenario
};

/// Returns an axis of the map as text: "delta = 0 to 2, 100 values" or "rod.length = 3 m to 6 m, 4 values,
/// log".
std::string axisText(const SweepAxis& axis, const ReadingStyle& style = plainStyle());

/// Returns the report as text: smallest and largest output with their positions, numbers of unsolved points,
/// and contours.
std::string mapText(const MapReport& report, const ReadingStyle& style = plainStyle());

/// Returns the report as one JSON object: axes, range of the output, unsolved points by reason, and the
/// contours with all their points (commands §4.9).
std::string mapJson(const MapReport& report);

/// First characters of a CSV file written by contoursCsv(). The program uses them to recognise such a file of
/// an earlier run.
inline constexpr std::string_view contoursCsvBegin = "level,line,";

/// Returns all points of the contours as CSV. Columns are level, number of the line (from 1, counted through
/// all levels), x and y in the units of the axes, and output. The last two are the residual |output − level|,
/// and the width of the jump if the output jumps at the point.
std::string contoursCsv(const MapReport& report);

}  // namespace drillwave
