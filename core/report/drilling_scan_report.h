// SPDX-License-Identifier: GPL-3.0-or-later
// Report of a scan, which computes sequences of blows for several values of a parameter, as text and CSV.
#pragma once

#include <string>
#include <vector>

#include "core/report/drilling_report.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// Scan of sequences of blows, with the text of its base scenario.
struct DrillingScanReport {
    DrillingScan scan;
    std::string scenarioText;
};

/// Returns the columns of all drillOutputs(), in the order of files §4.
std::vector<OutputColumn> drillingScanColumns(OutputUnits units);
/// Returns one CSV row for each value and initial state: the value, the initial state and drillOutputs().
std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units);
/// Returns the gap of every counted blow as CSV, with the value of the scanned parameter and the initial
/// state. Plotted over the value, the gaps are a bifurcation diagram.
std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units);
std::string drillingScanText(const DrillingScanReport& report, OutputUnits units,
                             const ReadingStyle& style = plainStyle());
std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units);

}  // namespace drillwave
