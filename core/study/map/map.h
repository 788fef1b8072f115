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

/// What to map.
struct MapStudy {
    Scenario base;
    SweepAxis x;          ///< SweepAxis::Kind::linear or logarithmic
    SweepAxis y;          ///< likewise, of another quantity
    OutputColumn output;  ///< in SI only for a scenario with units
    MethodChoice method = {};
    long workLimit = defaultWorkLimit;  ///< most wave pieces of a point; beyond, it is not solved
};

/// Most points of a map: they are all kept, nine bytes each.
inline constexpr std::uint64_t maximumMapPoints = 16'000'000;

/// What makes a map unusable, each in a line: what makes the sweep of the same axes so (problemsOf(Sweep)),
/// an axis without a range, too many points. Empty when it can be solved.
std::vector<Message> problemsOf(const MapStudy& study);

/// Told on the calling thread what there is so far, whenever some more points are there.
using MapProgress = std::function<void(const MapGrid& soFar)>;

/// Solves every point once: first a coarse grid of at most some hundred points, then those between, halving
/// the distance until all are there. Takes a stop token at every point: what is there by then stays. The
/// values do not depend on `jobs` (≥ 1), and each is that of the blow solved alone. Requires problemsOf() to
/// be empty.
MapGrid solveMap(const MapStudy& study, int jobs, std::stop_token stop = {},
                 const MapProgress& progress = {});

}  // namespace drillwave
