// SPDX-License-Identifier: GPL-3.0-or-later
// The pinned runs, and what was measured, as a report has them beside its own blow.
#pragma once

#include <stop_token>

#include "core/report/blow_report.h"
#include "ui/runs/runs.h"

namespace drillwave {

class UnitChoice;

/// The same runs, of which those that are solved know the margin of their thrust as a report does: a study of
/// all gaps each, not for the thread of the window.
RunList withMargins(const RunList& runs, const std::stop_token& stop);

/// Returns the differences and the results of a solved blow and of the solved runs, in the units of the
/// window, as on the page Compare; empty without such runs.
ReportComparison comparisonWith(const RunList& runs, const Blow& blow, const UnitChoice& units);

/// How far signals are from the solved blow, over the time that its plot in the report shows, in the units of
/// the window; empty without signals. The scenario has units, the blow its histories.
ReportComparison misfitsOf(const std::vector<MeasuredSignal>& measured, const Blow& blow,
                           const UnitChoice& units);

}  // namespace drillwave
