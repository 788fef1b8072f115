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

/// Indices of the panels of mapFigure(). `map` shows the output over both parameters; the other two show it
/// along the y or x direction through one point of the map.
enum class MapPanel { map, alongY, alongX };

/// Point of a map (column and row of its grid). The panels `alongY` and `alongX` show the output along the
/// lines through it. It is usually the point nearest to the present scenario.
struct MapSection {
    MapGrid::Place point;
    /// Whether the x (`isAtX`) or the y (`isAtY`) of the point agrees with the present scenario to five
    /// significant digits.
    bool isAtX = true, isAtY = true;
    bool operator==(const MapSection&) const = default;
};

/// Returns the values that the two parameters of the map have in `scenario`, as x and y in SI units. Empty if
/// the scenario lacks one of them.
std::optional<FigurePoint> mapPlaceOf(const MapStudy& study, const Scenario& scenario);

/// Returns the point of the map nearest to the position `here` (SI). Returns the middle of the map if `here`
/// is empty or outside.
MapSection mapSectionAt(const MapReport& report, const std::optional<FigurePoint>& here);

/// Returns the figure of a map, even if some points are not solved yet. The figure refers to the grid in
/// `report` and keeps it alive.
StudyFigure mapFigure(const std::shared_ptr<const MapReport>& report, const MapSection& section,
                      std::span<const Preset> presets);

/// Returns the title of a form field: the label of the parameter followed by `symbol`, such as "stiffness k".
/// Only the label if `symbol` is empty.
struct MapOutput {
    FigureAxis axis;
    double perValue = 1;
};
MapOutput mapOutput(const MapStudy& study);

/// Returns a sentence on a contour, such as "COR e exceeds 1 only where delta is above 0.3. …". Its level is
/// 1 for e, 0 for the feed margin, otherwise the largest level with a contour. If no bound in y exists, the
/// sentence says where the output is largest and smallest. Empty for an incomplete map.
std::optional<FigureText> mapAnswer(const MapReport& report);

/// Returns the default contour levels of an output. They are 1 for e, 0 for the margin of the feed force, 0.4
/// … 0.7 for the efficiency; none for other outputs.
std::vector<double> usualLevels(const Output& output);

}  // namespace drillwave
