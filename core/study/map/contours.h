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
    /// contourAccuracy and at most 100 times that. It is relative to the level or to the step between the
    /// grid points, whichever is larger.
    double jumpWidth = 0;
    /// Whether a value used to locate the point is a mean over a sequence of blows that does not repeat. Such
    /// values scatter, and so does the position.
    bool isIrregular = false;
    bool isJump() const { return jumpWidth > 0; }
    bool operator==(const ContourPoint&) const = default;
};

/// Accuracy with which the output at a contour point equals the level. It is relative to |level| or to the
/// difference of the two grid points beside it, whichever is larger. The value is a hundredth of 1e-9, the
/// accuracy of the coefficient of restitution e.
inline constexpr double contourAccuracy = 1e-11;

/// Connected line of contour points. A closed line ends with a copy of its first point.
using ContourLine = std::vector<ContourPoint>;

/// Contour: all lines of one level of a map.
struct Contour {
    double level = 0;
    std::vector<ContourLine> lines;
    /// Number of contour points that could not be located, because a blow between the two grid points beside
    /// them was not solved.
    std::uint64_t unplaced = 0;
    /// Reason why a contour point could not be located, for the first of the `unplaced` points; empty if
    /// there are none.
    Message reason;
    std::uint64_t solves = 0;  ///< number of blows solved to locate the points
    bool stopped = false;      ///< set if the stop token ended the search; `lines` is then empty

    /// Returns the number of points of all lines; the first point of a closed line counts once.
    std::uint64_t pointCount() const;
    std::uint64_t jumpCount() const;
    /// Returns the number of points with ContourPoint::isIrregular; the first point of a closed line counts
    /// once.
    std::uint64_t irregularCount() const;
    /// Returns the largest ContourPoint::residual of all points that are not jumps; 0 if there are none.
    double worstResidual() const;
    bool operator==(const Contour&) const = default;
};

/// Points of a contour with the smallest and the largest y.
struct ContourExtent {
    ContourPoint lowest, highest;
};
/// Returns the points of a contour with the smallest and the largest y, the first ones if several are equal;
/// empty if the contour has no lines.
std::optional<ContourExtent> extentOf(const Contour& contour);

/// Side of a contour, along y, on which the map exceeds the level.
enum class LevelSide {
    /// The output exceeds the level at larger y: somewhere in the row of the largest y, nowhere in that of
    /// the smallest y.
    above,
    /// The output exceeds the level at smaller y: somewhere in the row of the smallest y, nowhere in that of
    /// the largest y.
    below,
    mixed,
};
/// Returns on which side of a contour, along y, a complete map exceeds the level. LevelSide::mixed is
/// returned if both the first and the last row have such points, or neither has.
LevelSide sideOf(const MapGrid& grid, double level);

/// Callback for progress, called on the calling thread with the numbers of contour points located so far and
/// in total.
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
