// SPDX-License-Identifier: GPL-3.0-or-later
// Report of a sequence of blows: columns, units, sentences, text, JSON and CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/blow/outputs.h"
#include "core/report/report_text.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/rows/output_column.h"
#include "core/study/scan/drilling_scan.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Value of the member `method` in the JSON of a sequence of blows. The waves are computed in cells, short
/// time intervals in which a wave is a polynomial.
inline constexpr const char* drillingMethod = "cells";

/// Contents of the report of a sequence of blows.
struct DrillingReport {
    DrillingResult result;
    /// Required feed force from single blows of the scenario; empty without an estimate.
    std::optional<FeedEstimate> feed;
    std::string scenarioText;
};

/// Units for one kind of quantity, such as lengths, in the results of a sequence of blows. Used to convert
/// results for output.
struct DrillingScale {
    Quantity quantity = Quantity::ratio;
    double si = 1;        ///< SI value of the unit that Problem uses
    double multiple = 1;  ///< SI value of the unit shown for scenarios without units

    double value(double ofProblem, OutputUnits units) const {
        return units == OutputUnits::si ? ofProblem * si : ofProblem * si / multiple;
    }
};
/// Returns the units of one kind of quantity, such as lengths, for the result of a sequence of blows.
DrillingScale scaleOf(DrillingMeasure measure, const DrillingResult& result);

/// Returns a standard deviation or an error for display, or 0 if its magnitude is below 1e-9, which is only
/// rounding. The values are in the dimensionless units of Problem.
double withoutRounding(double spread);

/// Returns sentences on the required feed force, then on the results of the sequence.
std::vector<Message> drillingSentences(const DrillingReport& report,
                                       const ReadingStyle& style = plainStyle());

/// Returns in a few words whether the motion repeats, and whether a small disturbance grows. Requires
/// statistics.
Message motionWords(const DrillingResult& result);
/// Returns the Lyapunov exponent λ with its name and error; empty if it was not computed.
Message exponentWords(const DrillingResult& result, const ReadingStyle& style = plainStyle());
/// Returns one text that states whether the motion repeats, and the Lyapunov exponent. Requires statistics.
Message regimeWords(const DrillingResult& result, const ReadingStyle& style = plainStyle());

std::string drillingJson(const DrillingReport& report, OutputUnits units);
/// Returns the column headings of drillingCsv(), such as "gap [m]", without that of the blow number.
std::vector<std::string> drillingHeaders(const DrillingResult& result, OutputUnits units);
/// Returns the scenario as comment lines, then one CSV row for every blow.
std::string drillingCsv(const DrillingReport& report, OutputUnits units);
/// Returns the scenario as comment lines, then the recorded histories as CSV with one row for every instant.
std::string drillingHistoriesCsv(const DrillingReport& report, OutputUnits units);

/// Returns a table with headings and one line per quantity of a blow: mean, error, standard deviation and
/// quantiles. Requires statistics.
TextGrid sequenceGrid(const DrillingResult& result, OutputUnits units,
                      const ReadingStyle& style = plainStyle());

/// Returns the report as text. It states whether the feed force is enough, means and scatter of gap,
/// penetration, impulse and force, and whether the motion repeats. Energy, errors of the balances and alerts
/// follow.
std::string drillingText(const DrillingReport& report, OutputUnits units,
                         const ReadingStyle& style = plainStyle());

}  // namespace drillwave
