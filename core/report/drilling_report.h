// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences of blows with what is reported about them: columns, units, sentences, text, JSON and CSV.
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

/// The method of consecutive blows in JSON.
inline constexpr const char* drillingMethod = "cells";

/// Many blows, what single ones require, and the text of the scenario they are of.
struct DrillingReport {
    DrillingResult result;
    std::optional<FeedEstimate> feed;  ///< of the blow of the scenario
    std::string scenarioText;
};

/// SI value of the unit of Problem, unit of the multiples in scenarios without units, and the quantity.
struct DrillingScale {
    Quantity quantity = Quantity::ratio;
    double si = 1;        ///< SI value of 1 in units of Problem
    double multiple = 1;  ///< SI value of the unit of multiples

    double value(double ofProblem, OutputUnits units) const {
        return units == OutputUnits::si ? ofProblem * si : ofProblem * si / multiple;
    }
};
DrillingScale scaleOf(DrillingMeasure measure, const DrillingResult& result);

/// Returns a spread or an error, in units of Problem, for text: rounding alone becomes zero.
double withoutRounding(double spread);

/// Sentences on the required feed, then on the results of the sequence.
std::vector<Message> drillingSentences(const DrillingReport& report,
                                       const ReadingStyle& style = plainStyle());

/// Whether the motion repeats, with λ; requires statistics.
Message regimeWords(const DrillingResult& result, const ReadingStyle& style = plainStyle());

std::string drillingJson(const DrillingReport& report, OutputUnits units);
/// "gap [m]" and so on: what heads the columns of drillingCsv() behind the number of the blow.
std::vector<std::string> drillingHeaders(const DrillingResult& result, OutputUnits units);
/// A row for every blow, behind the scenario.
std::string drillingCsv(const DrillingReport& report, OutputUnits units);
/// Blows whose histories are written, instant by instant.
std::string drillingHistoriesCsv(const DrillingReport& report, OutputUnits units);

/// Returns a line of titles, then mean, error, deviation and quantiles of each quantity of a blow. Requires
/// statistics.
TextGrid sequenceGrid(const DrillingResult& result, OutputUnits units,
                      const ReadingStyle& style = plainStyle());

/// Returns statements on the feed, spreads of gap, penetration, impulse and force, whether the motion
/// repeats, energy and balances, alerts.
std::string drillingText(const DrillingReport& report, OutputUnits units,
                         const ReadingStyle& style = plainStyle());

}  // namespace drillwave
