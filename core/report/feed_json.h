// SPDX-License-Identifier: GPL-3.0-or-later
// The keys `feed` and `sequence` of JSON: the same in all commands that have them.
#pragma once

#include <optional>

#include "core/blow/feed_estimate.h"
#include "core/report/json_value.h"
#include "core/study/drilling/sequence.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/scan_comparison.h"

namespace drillwave {

/// Returns the forces that single blows require, N; null without an estimate.
Json feedJson(const std::optional<FeedEstimate>& feed);

/// Returns the means of a sequence, and how they compare with the best of a scan; null without statistics.
/// Lengths are in m or, dimensionless, in d0; the rate is in m/s.
Json sequenceJson(const DrillingResult& result, OutputUnits units, const ScanComparison* scan = nullptr);

}  // namespace drillwave
