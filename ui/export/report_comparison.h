// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of a report's blow with pinned runs and measured signals.
#pragma once

#include <stop_token>

#include "core/report/blow_report.h"
#include "ui/runs/runs.h"

namespace drillwave {

class UnitChoice;

/// Returns a copy of the pinned runs (results kept for comparison), with the margin of the feed force of each
/// solved run. This solves many blows for each run, so do not call it in the window's thread.
RunList withMargins(const RunList& runs, const std::stop_token& stop);

/// Returns a table that compares a solved blow with the pinned runs (results kept for comparison). It
/// contains inputs that differ, and results, in the units of the window. Empty if no run is solved.
ReportComparison comparisonWith(const RunList& runs, const Blow& blow, const UnitChoice& units);

/// Returns a table of the deviations between measured signals and the solved blow; empty without signals. The
/// deviations cover the time span of the report's plot and are in the units of the window. Requires a
/// scenario with units and a blow with histories.
ReportComparison misfitsOf(const std::vector<MeasuredSignal>& measured, const Blow& blow,
                           const UnitChoice& units);

}  // namespace drillwave
