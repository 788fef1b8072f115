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

/// Returns the required feed forces of single blows as JSON [N]; null without an estimate.
Json feedJson(const std::optional<FeedEstimate>& feed);

/// Returns the means of a sequence of blows as JSON, with a comparison to the best value of `scan` if given;
/// null without statistics. Lengths are in m, or in d0 if dimensionless; the penetration rate is in m/s.
Json sequenceJson(const DrillingResult& result, OutputUnits units, const ScanComparison* scan = nullptr);

}  // namespace drillwave
