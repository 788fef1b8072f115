// SPDX-License-Identifier: GPL-3.0-or-later
// A scan of many blows as text and CSV.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/report/drilling_report.h"
#include "core/study/drilling/drilling_scan.h"

namespace drillwave {

/// A number of many blows by name, for columns: `drill_…`.
struct DrillingOutput {
    std::string_view name;
    std::string_view meaning;
    DrillingMeasure measure;
    bool isRate = false;  ///< in m/s, in SI alone
    /// In units of Problem, a rate in SI; not a number where there is none.
    double (*value)(const DrillingResult&);
};
std::span<const DrillingOutput> drillingOutputs();

/// What is scanned, and the text of the scenario it starts from.
struct DrillingScanReport {
    DrillingScan scan;
    std::string scenarioText;
};

/// A row for each value and start.
std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units);
/// The gap of every blow that counts, with value and start: a bifurcation diagram.
std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units);
std::string drillingScanText(const DrillingScanReport& report, OutputUnits units,
                             const ReadingStyle& style = plainStyle());
std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units);

}  // namespace drillwave
