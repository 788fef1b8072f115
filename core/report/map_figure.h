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

/// Indices of the panels of mapFigure(): the map, and the output over y and over x through one point.
enum class MapPanel { map, alongY, alongX };

/// Point of a map (column and row) through which the panels `alongY` and `alongX` show the output, usually
/// the one nearest to the present scenario.
struct MapSection {
    MapGrid::Place point;
    /// Whether the point has the x (`isAtX`) and the y (`isAtY`) of the present scenario, to five significant
    /// digits.
    bool isAtX = true, isAtY = true;
    bool operator==(const MapSection&) const = default;
};

/// Returns the values of the map's two parameters in a scenario, in SI; empty if the scenario lacks one of
/// them.
std::optional<FigurePoint> mapPlaceOf(const MapStudy& study, const Scenario& scenario);

/// Returns the point of the map nearest to the position `here` (SI). Returns the middle of the map if `here`
/// is empty or outside.
MapSection mapSectionAt(const MapReport& report, const std::optional<FigurePoint>& here);

/// Returns the figure of a map, even if some points are not solved yet. The figure shares ownership of the
/// grid of the report.
StudyFigure mapFigure(const std::shared_ptr<const MapReport>& report, const MapSection& section,
                      std::span<const Preset> presets);

/// Axis for the output of a map. A value of the map times `perValue` is the number on the axis.
struct MapOutput {
    FigureAxis axis;
    double perValue = 1;
};
MapOutput mapOutput(const MapStudy& study);

/// Returns a sentence that states above or below which y the output exceeds the level of a contour. The level
/// is 1 for e, 0 for the feed margin, otherwise the largest level with a contour. If there is no such y, the
/// sentence says where the output is largest and smallest. Empty for an incomplete map.
std::optional<FigureText> mapAnswer(const MapReport& report);

/// Returns the default contour levels of an output. They are 1 for e, 0 for the margin of the feed force, 0.4
/// … 0.7 for the efficiency; none for other outputs.
std::vector<double> usualLevels(const Output& output);

}  // namespace drillwave
