// SPDX-License-Identifier: GPL-3.0-or-later
// Where an output takes a level in a map: points placed by the solver, not by the grid.
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

/// A point of a contour, on a line between two neighbouring points of the grid.
struct ContourPoint {
    double x = 0;         ///< SI
    double y = 0;         ///< SI
    double value = 0;     ///< the output there, in the units of the map
    double residual = 0;  ///< |value − level|
    /// Where the output jumps across the level: width that encloses the jump, as a fraction of the distance
    /// between the two points of the grid. 0 where it takes the level: `residual` is then mostly below
    /// contourAccuracy, and always below a hundred times as much, relative to the level or the step between
    /// the two points, whichever is larger.
    double jumpWidth = 0;
    /// Whether the output was a mean of blows that do not repeat, on the way to the point: it scatters, and
    /// so does the place.
    bool isIrregular = false;
    bool isJump() const { return jumpWidth > 0; }
    bool operator==(const ContourPoint&) const = default;
};

/// Accuracy of a point, relative to the level or the step: for e a hundredth of 1e-9.
inline constexpr double contourAccuracy = 1e-11;

/// Connected line; the last point of a closed one is the first again.
using ContourLine = std::vector<ContourPoint>;

/// All lines of one level.
struct Contour {
    double level = 0;
    std::vector<ContourLine> lines;
    std::uint64_t unplaced = 0;  ///< crossings that could not be placed: a blow on the way was not solved
    Message reason;              ///< the first reason why
    std::uint64_t solves = 0;    ///< blows solved to place it
    bool stopped = false;        ///< on the stop token: there are no lines

    std::uint64_t pointCount() const;  ///< a closed line's first point counted once
    std::uint64_t jumpCount() const;
    std::uint64_t irregularCount() const;  ///< a closed line's first point counted once
    double worstResidual() const;          ///< of the points that are no jumps; 0 without any
    bool operator==(const Contour&) const = default;
};

/// The points of a contour with the smallest and the largest y.
struct ContourExtent {
    ContourPoint lowest, highest;
};
/// Returns the first of such points; nothing without lines.
std::optional<ContourExtent> extentOf(const Contour& contour);

/// Where along y a map exceeds a level.
enum class LevelSide {
    above,  ///< only above its contour: no point of the lowest row does
    below,  ///< only below: no point of the highest row does
    mixed,
};
/// Returns the side for a complete map; LevelSide::mixed also where no point or every row exceeds the level.
LevelSide sideOf(const MapGrid& grid, double level);

/// Called on the calling thread with the number of placed crossings and of all crossings.
using ContourProgress = std::function<void(std::uint64_t placed, std::uint64_t crossings)>;

/// Returns the contour of one level (finite, in the units of the map) through the present points of `grid`:
/// those of every grid.stride()-th column and row. Between two neighbouring points of which one is below the
/// level and the other is not, one point is placed by root finding. Where a square of four is crossed twice,
/// its middle decides how the points are connected. Squares with a point without a value are left out. The
/// work is at most some dozen blows per crossing; the result does not depend on `jobs` (≥ 1).
Contour contourOf(const MapStudy& study, const MapGrid& grid, double level, int jobs,
                  std::stop_token stop = {}, const ContourProgress& progress = {});

}  // namespace drillwave
