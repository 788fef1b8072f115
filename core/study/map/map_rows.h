// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a map to rows like those of a sweep over its two axes.
#pragma once

#include "core/study/map/map.h"
#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Passes one row for each point to the sink and returns the counts. A row has the two axis values (SI) and
/// the output; y varies fastest, as in a sweep over x and then y. A point that is not present has no output,
/// like an unsolved one.
RowCounts giveRows(const MapStudy& study, const MapGrid& grid, RowSink& sink);

}  // namespace drillwave
