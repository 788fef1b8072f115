// SPDX-License-Identifier: GPL-3.0-or-later
// JSON members `feed` and `sequence`, which are the same in all commands that have them.
#pragma once

#include <optional>

#include "core/blow/feed_estimate.h"
#include "core/report/json_value.h"
#include "core/study/drilling/sequence.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/scan_comparison.h"

namespace drillwave {

/// Returns the estimate of the required feed force from single blows as a JSON object, with forces in N; null
/// if `feed` is empty.
Json feedJson(const std::optional<FeedEstimate>& feed);

/// Returns the means of a sequence of blows as JSON; null without statistics. If `scan` is given, the
/// penetration rate is also compared with the best one of the scan. Lengths are in m, or in d0 if
/// dimensionless; the penetration rate is in m/s.
Json sequenceJson(const DrillingResult& result, OutputUnits units, const ScanComparison* scan = nullptr);

}  // namespace drillwave
