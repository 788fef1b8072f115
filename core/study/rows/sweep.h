// SPDX-License-Identifier: GPL-3.0-or-later
// A product grid of parameters solved point by point.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/row_sink.h"
#include "core/study/rows/shard.h"
#include "core/study/rows/sweep_axis.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Settings of a sweep: every combination of the values of the axes, later axes fastest.
struct Sweep {
    Scenario base;
    std::vector<SweepAxis> axes;  ///< at least one
    std::vector<OutputColumn> columns;
    Shard shard;
    std::uint64_t done = 0;  ///< rows of the part that are there already and are left out
    MethodChoice method = {};
    long workLimit = defaultWorkLimit;  ///< most wave pieces of a row; beyond, it is not solved
};

/// Most axes of one sweep.
inline constexpr std::size_t maximumSweepAxes = 8;

/// Number of points of the whole grid; 0 if there are more than maximumSweepPoints.
std::uint64_t pointCount(const Sweep& sweep);

/// Passes the rows to the sink in order: the values of the axes (SI), then the outputs. `progress` is called
/// on the calling thread. Memory does not grow with the number of points; the rows do not depend on `jobs` (≥
/// 1). Requires problemsOf() to be empty.
RowCounts runSweep(const Sweep& sweep, int jobs, std::stop_token stop, RowSink& sink,
                   const RowProgress& progress);

}  // namespace drillwave
