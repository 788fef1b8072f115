// SPDX-License-Identifier: GPL-3.0-or-later
// A scan of many blows as text and CSV.
#pragma once

#include <string>
#include <vector>

#include "core/report/drilling_report.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// A scan and the text of the scenario it starts from.
struct DrillingScanReport {
    DrillingScan scan;
    std::string scenarioText;
};

/// All of drillOutputs(), in the order of files §4.
std::vector<OutputColumn> drillingScanColumns(OutputUnits units);
/// A row for each value and start: the value, the start, and drillOutputs().
std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units);
/// The gap of every blow that counts, with value and start: a bifurcation diagram.
std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units);
std::string drillingScanText(const DrillingScanReport& report, OutputUnits units,
                             const ReadingStyle& style = plainStyle());
std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units);

}  // namespace drillwave
