// SPDX-License-Identifier: GPL-3.0-or-later
// A map with its contours, and all that is reported about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/map/contours.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// All that is reported.
struct MapReport {
    MapStudy study;
    MapGrid grid;                   ///< complete
    std::vector<Contour> contours;  ///< of the levels, in the order in which they were asked for
    double runTime = 0;             ///< [s]
    std::string scenarioText;       ///< gives the same scenario again
};

/// "delta = 0 to 2, 100 values" or "rod.length = 3 m to 6 m, 4 values, log".
std::string axisText(const SweepAxis& axis, const ReadingStyle& style = plainStyle());

/// Summary for people: the range of the output and where it ends, unsolved points, contours.
std::string mapText(const MapReport& report, const ReadingStyle& style = plainStyle());

/// One object: axes, range, unsolved points by reason, and the contours with all their points (commands
/// §4.9).
std::string mapJson(const MapReport& report);

/// How the file of contours begins.
inline constexpr std::string_view contoursCsvBegin = "level,line,";

/// The points of all contours: level, number of the line (from 1, through all levels), the two parameters in
/// the units of the map, output, residual, and the width of the jump where it is one.
std::string contoursCsv(const MapReport& report);

}  // namespace drillwave
