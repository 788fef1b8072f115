// SPDX-License-Identifier: GPL-3.0-or-later
// A map as rows, those that a sweep of its two axes has.
#pragma once

#include "core/study/map/map.h"
#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Gives the sink a row for each point in the order of a sweep over x and then y, y fastest: the two values
/// (SI) and the output. A point that is not there has no output, as one that was not solved.
RowCounts giveRows(const MapStudy& study, const MapGrid& grid, RowSink& sink);

}  // namespace drillwave
