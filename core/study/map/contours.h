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
    /// Width within which the output jumps across the level, as a fraction of the distance between the two
    /// grid points. It is 0 if the output takes the level continuously. Then `residual` is mostly below
    /// contourAccuracy and always below 100 contourAccuracy, relative to the level or the step between the
    /// grid points, whichever is larger.
    double jumpWidth = 0;
    /// Whether an output used to locate the point was a mean of blows that do not repeat. The output then
    /// scatters, and so does the position.
    bool isIrregular = false;
    bool isJump() const { return jumpWidth > 0; }
    bool operator==(const ContourPoint&) const = default;
};

/// Accuracy of a contour point, relative to the level or to the step between grid points. It is a hundredth
/// of 1e-9, the accuracy of the coefficient of restitution e.
inline constexpr double contourAccuracy = 1e-11;

/// Connected line of contour points. A closed line ends with a copy of its first point.
using ContourLine = std::vector<ContourPoint>;

/// Contour: all lines of one level of a map.
struct Contour {
    double level = 0;
    std::vector<ContourLine> lines;
    /// Number of points between grid points on either side of the level that could not be located because a
    /// blow was not solved.
    std::uint64_t unplaced = 0;
    /// Reason why the first of the missing points could not be located; empty if none is missing.
    Message reason;
    std::uint64_t solves = 0;  ///< number of blows solved to locate the points
    bool stopped = false;      ///< set if the stop token ended the search; `lines` is then empty

    /// Returns the number of points of all lines; the first point of a closed line counts once.
    std::uint64_t pointCount() const;
    std::uint64_t jumpCount() const;
    /// Returns the number of irregular points (see ContourPoint::isIrregular); the first point of a closed
    /// line counts once.
    std::uint64_t irregularCount() const;
    /// Returns the largest residual of all points that are not jumps; 0 if there are none.
    double worstResidual() const;
    bool operator==(const Contour&) const = default;
};

/// Points of a contour with the smallest and the largest y.
struct ContourExtent {
    ContourPoint lowest, highest;
};
/// Returns the lowest and highest point of a contour, the first if there are several; empty without lines.
std::optional<ContourExtent> extentOf(const Contour& contour);

/// Side of a contour, along y, on which the map exceeds the level.
enum class LevelSide {
    /// The level is exceeded only above the contour (larger y); no point of the lowest row exceeds it.
    above,
    /// The level is exceeded only below the contour (smaller y); no point of the highest row exceeds it.
    below,
    mixed,
};
/// Returns the side for a complete map. LevelSide::mixed is also returned if no point exceeds the level, or
/// points in every row do.
LevelSide sideOf(const MapGrid& grid, double level);

/// Callback for progress, called on the calling thread with the number of located crossings and of all
/// crossings.
using ContourProgress = std::function<void(std::uint64_t placed, std::uint64_t crossings)>;

/// Returns the contour at one level (finite, in the units of the map). Uses the points of every
/// grid.stride()-th column and row. If one of two neighbouring points is below the level and the other is
/// not, one contour point is located between them by root finding.
/// In a square with four crossings, the value at its centre decides how the points are connected. Squares
/// with a point without a value are left out. Each crossing takes at most some dozen blows. The result does
/// not depend on the number of threads `jobs` (≥ 1).
Contour contourOf(const MapStudy& study, const MapGrid& grid, double level, int jobs,
                  std::stop_token stop = {}, const ContourProgress& progress = {});

}  // namespace drillwave
