// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a map to rows like those of a sweep over its two axes.
#pragma once

#include "core/study/map/map.h"
#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Passes the points of a map to `sink` as rows of numbers, for example to write CSV, and returns the numbers
/// of rows. A row has x, y (SI) and the output; y varies fastest. If the map was stopped early, points that
/// were not computed have no output and count as failed.
RowCounts giveRows(const MapStudy& study, const MapGrid& grid, RowSink& sink);

}  // namespace drillwave
