// SPDX-License-Identifier: GPL-3.0-or-later
// Map of an output over two parameters: a grid of blows, solved from coarse to fine.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/study/map/map_grid.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/sweep_axis.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Settings of a map, the values of one output on a grid of two parameters.
struct MapStudy {
    Scenario base;
    SweepAxis x;  ///< parameter along x, with a linear or logarithmic range
    SweepAxis y;  ///< parameter along y, with a linear or logarithmic range of another quantity than x
    OutputColumn output;  ///< output to compute; in SI units only if the scenario has units
    MethodChoice method = {};
    /// Maximum work of one point, in wave pieces (the solver's unit of work). Points that need more are not
    /// solved.
    long workLimit = defaultWorkLimit;
};

/// Maximum number of points of a map. All are kept in memory with nine bytes each.
inline constexpr std::uint64_t maximumMapPoints = 16'000'000;

/// Returns the reasons why a map cannot be computed, one message each; empty if it can. Examples are an axis
/// that is not a range, or too many points. Otherwise the checks are those of a sweep over both axes.
std::vector<Message> problemsOf(const MapStudy& study);

/// Callback for progress, called on the calling thread with the map so far whenever more points are solved.
using MapProgress = std::function<void(const MapGrid& soFar)>;

/// Returns the map with every point solved once. First solves a coarse grid of some hundred points, then
/// repeatedly halves the spacing. After a stop request, the points solved so far are kept. Values are the
/// same for any number of threads `jobs` (≥ 1), and the same as those of separately solved blows. If
/// problemsOf() is not empty, returns a map without points, with the problems as MapGrid::refusal().
MapGrid solveMap(const MapStudy& study, int jobs, std::stop_token stop = {},
                 const MapProgress& progress = {});

}  // namespace drillwave
