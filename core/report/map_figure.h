// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of a map: colours over two parameters with contours, and sections through the present scenario.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/model/preset.h"
#include "core/report/figure.h"
#include "core/report/map_report.h"

namespace drillwave {

/// Panels of mapFigure().
enum class MapPanel { map, alongY, alongX };

/// Column and row of a map that are nearest to a scenario, for the sections through it.
struct MapSection {
    MapGrid::Place point;
    bool isAtX = true, isAtY = true;  ///< whether the point has the values of the scenario, to five digits
    bool operator==(const MapSection&) const = default;
};

/// Returns the values of the two parameters in a scenario; empty if one of them is missing.
std::optional<FigurePoint> mapPlaceOf(const MapStudy& study, const Scenario& scenario);

/// Returns the sections nearest to a place; those through the middle if there is none or it is outside.
MapSection mapSectionAt(const MapReport& report, const std::optional<FigurePoint>& here);

/// Returns the figure of a map, even if the map is not complete. It shares the grid of the report.
StudyFigure mapFigure(const std::shared_ptr<const MapReport>& report, const MapSection& section,
                      std::span<const Preset> presets);

/// Returns an output of the map as an axis of a figure. Numbers there are values of the map · `perValue`.
struct MapOutput {
    FigureAxis axis;
    double perValue = 1;
};
MapOutput mapOutput(const MapStudy& study);

/// Returns the side of the deciding level, or else of the largest level with a contour, on which the output
/// exceeds it. Without such a side, returns where the output is largest and smallest. Empty for a map that is
/// not complete.
std::optional<FigureText> mapAnswer(const MapReport& report);

/// Returns the default levels for contours of an output: the level that decides (1 for e, 0 for the margin of
/// the feed force), or tenths of an efficiency.
std::vector<double> usualLevels(const Output& output);

}  // namespace drillwave
