// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a map. Their points are located by solving blows, not by interpolation in the grid.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/study/map/map.h"
#include "core/text/message.h"

namespace drillwave {

/// Point of a contour, on the line between two neighbouring points of the grid.
struct ContourPoint {
    double x = 0;         ///< value of the x parameter, in SI units
    double y = 0;         ///< value of the y parameter, in SI units
    double value = 0;     ///< output at the point, in the units of the map
    double residual = 0;  ///< |value − level|, in the units of the map
    /// Width of the interval in which the output jumps across the level, as a fraction of the distance
    /// between the two grid points. It is 0 if the output takes the level continuously. `residual` is then
    /// mostly below contourAccuracy, and at most 100 times that, in the relative measure of contourAccuracy.
    double jumpWidth = 0;
    /// Whether the point is uncertain because it was located with the mean of a sequence of blows that does
    /// not repeat. Such means scatter, and so does the position.
    bool isIrregular = false;
    bool isJump() const { return jumpWidth > 0; }
    bool operator==(const ContourPoint&) const = default;
};

/// Accuracy with which the output at a contour point equals the level. It is relative to |level| or to the
/// difference between the two grid points beside it, whichever is larger. The coefficient of restitution e
/// has an accuracy of 1e-9; 1e-11 adds little to that error.
inline constexpr double contourAccuracy = 1e-11;

/// Connected line of contour points. A closed line ends with a copy of its first point.
using ContourLine = std::vector<ContourPoint>;

/// Contour: all lines of one level of a map.
struct Contour {
    double level = 0;
    std::vector<ContourLine> lines;
    /// Number of contour points that could not be located, because a blow between the two neighbouring grid
    /// points was not solved.
    std::uint64_t unplaced = 0;
    /// Reason why a contour point could not be located, for the first of the `unplaced` points; empty if
    /// there are none.
    Message reason;
    std::uint64_t solves = 0;  ///< number of blows solved to locate the points
    bool stopped = false;      ///< set if the stop token ended the search; `lines` is then empty

    /// Returns the number of points of all lines; the first point of a closed line counts once.
    std::uint64_t pointCount() const;
    std::uint64_t jumpCount() const;
    /// Returns the number of points with an uncertain position (see ContourPoint::isIrregular). The first
    /// point of a closed line counts once.
    std::uint64_t irregularCount() const;
    /// Returns the largest distance |value − level| of the output from the level over all contour points; 0
    /// if there are none. Points at which the output jumps across the level are left out.
    double worstResidual() const;
    bool operator==(const Contour&) const = default;
};

/// Points of a contour with the smallest and the largest y.
struct ContourExtent {
    ContourPoint lowest, highest;
};
/// Returns the points of a contour with the smallest and the largest y; empty if the contour has no lines. If
/// several points have the same y, the first one is returned.
std::optional<ContourExtent> extentOf(const Contour& contour);

/// Direction along y, larger or smaller, in which the output of a map is above a level.
enum class LevelSide {
    /// The map is above the level towards larger y: some point in the row of the largest y is above it, but
    /// no point in the row of the smallest y.
    above,
    /// The map is above the level towards smaller y: some point in the row of the smallest y is above it, but
    /// no point in the row of the largest y.
    below,
    mixed,
};
/// Returns whether a complete map is above the level towards larger or towards smaller y. Returns
/// LevelSide::mixed if both the row of the smallest y and that of the largest y have points above the level,
/// or neither has.
LevelSide sideOf(const MapGrid& grid, double level);

/// Callback for progress, called on the calling thread. It receives the number of contour points located so
/// far and the number of all contour points.
using ContourProgress = std::function<void(std::uint64_t placed, std::uint64_t crossings)>;

/// Returns the contour of a map at one level (finite, in the units of the map). Uses the finest grid of
/// points that is completely computed (see MapGrid::stride()). If only one of two neighbouring points is
/// below the level, one contour point between them is located by root finding.
/// In a square with four crossings, the value at its centre decides how the points are connected. Squares are
/// left out if one of their corners has no value. Each crossing takes at most some dozen blows. The result
/// does not depend on the number of threads `jobs` (≥ 1).
Contour contourOf(const MapStudy& study, const MapGrid& grid, double level, int jobs,
                  std::stop_token stop = {}, const ContourProgress& progress = {});

}  // namespace drillwave
