// SPDX-License-Identifier: GPL-3.0-or-later
// Report of a scan, which computes sequences of blows for several values of a parameter, as text and CSV.
#pragma once

#include <string>
#include <vector>

#include "core/report/drilling_report.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// Scan: sequences of blows computed for several values of one parameter. Includes the text of the base
/// scenario.
struct DrillingScanReport {
    DrillingScan scan;
    std::string scenarioText;
};

/// Returns a column for each output of a sequence of blows (drillOutputs()), in the order of files §4.
std::vector<OutputColumn> drillingScanColumns(OutputUnits units);
/// Returns one CSV row for each scanned value and initial state: the value, the initial state, and the
/// outputs of the sequence of blows (drillOutputs()).
std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units);
/// Returns the gap at every counted blow of every sequence as CSV, with the scanned value and the initial
/// state. Plotted over the scanned value, the gaps are a bifurcation diagram.
std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units);
std::string drillingScanText(const DrillingScanReport& report, OutputUnits units,
                             const ReadingStyle& style = plainStyle());
std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units);

}  // namespace drillwave
