// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of a report's own blow with the pinned runs and the measured signals.
#pragma once

#include <stop_token>

#include "core/report/blow_report.h"
#include "ui/runs/runs.h"

namespace drillwave {

class UnitChoice;

/// Returns the runs, the solved ones with the margin of their thrust as in a report: a study of all gaps
/// each, not for the thread of the window.
RunList withMargins(const RunList& runs, const std::stop_token& stop);

/// Returns the differences and the results of a solved blow and of the solved runs, in the units of the
/// window, as on the page Compare; empty without such runs.
ReportComparison comparisonWith(const RunList& runs, const Blow& blow, const UnitChoice& units);

/// Returns the deviations of signals from the solved blow, over the time of its plot in the report, in the
/// units of the window; empty without signals. The scenario has units, the blow its histories.
ReportComparison misfitsOf(const std::vector<MeasuredSignal>& measured, const Blow& blow,
                           const UnitChoice& units);

}  // namespace drillwave
