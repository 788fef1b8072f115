// SPDX-License-Identifier: GPL-3.0-or-later
// An output over two parameters: a grid of solved blows, coarse first.
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

/// Settings of a map.
struct MapStudy {
    Scenario base;
    SweepAxis x;          ///< SweepAxis::Kind::linear or logarithmic
    SweepAxis y;          ///< the same, of another quantity
    OutputColumn output;  ///< in SI only for a scenario with units
    MethodChoice method = {};
    long workLimit = defaultWorkLimit;  ///< maximum wave pieces of a point; with more, it is not solved
};

/// Maximum number of points of a map: all are kept, nine bytes each.
inline constexpr std::uint64_t maximumMapPoints = 16'000'000;

/// Returns the problems of a map, each in a line: those of the sweep of the same axes (problemsOf(Sweep)), an
/// axis without a range, too many points. Empty if it can be solved.
std::vector<Message> problemsOf(const MapStudy& study);

/// Called on the calling thread with the map so far, whenever some more points are solved.
using MapProgress = std::function<void(const MapGrid& soFar)>;

/// Solves every point once: first a coarse grid of at most some hundred points, then those between,
/// halving the distance until all are solved. Checks the stop token at every point: points solved by then
/// stay. Values do not depend on `jobs` (≥ 1), and are those of single blows. Requires problemsOf() to be
/// empty.
MapGrid solveMap(const MapStudy& study, int jobs, std::stop_token stop = {},
                 const MapProgress& progress = {});

}  // namespace drillwave
