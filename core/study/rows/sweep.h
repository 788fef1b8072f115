// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep over a product grid of parameters, solved point by point.
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

/// Settings of a sweep, which solves every combination of the axis values. The last axis varies fastest.
struct Sweep {
    Scenario base;
    std::vector<SweepAxis> axes;  ///< axes of the grid, 1 … maximumSweepAxes
    std::vector<OutputColumn> columns;
    Shard shard;
    std::uint64_t done = 0;  ///< number of rows that an earlier run has already computed; they are skipped
    MethodChoice method = {};
    /// Maximum work of one row, in wave pieces (the solver's unit of work). Rows that need more are not
    /// solved.
    long workLimit = defaultWorkLimit;
};

/// Maximum number of axes of one sweep.
inline constexpr std::size_t maximumSweepAxes = 8;

/// Returns the number of points of the whole grid; 0 if it exceeds maximumSweepPoints.
std::uint64_t pointCount(const Sweep& sweep);

/// Solves the points of a sweep and passes the result rows in order to `sink`, such as a CSV file. Returns
/// how many rows were completed and how many of them failed. A row has the values of the axes (SI), then the
/// outputs. `progress` is called on the calling thread. Memory does not grow with the number of points. The
/// rows do not depend on the number of threads `jobs` (≥ 1). Requires problemsOf() to be empty.
RowCounts runSweep(const Sweep& sweep, int jobs, std::stop_token stop, RowSink& sink,
                   const RowProgress& progress);

}  // namespace drillwave
