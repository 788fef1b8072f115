// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics over the gap with all that is reported about them: text, JSON and CSV.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/report/report_text.h"
#include "core/study/gap/gap_study.h"
#include "core/study/rows/output_column.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// All that is reported.
struct GapReport : GapStudy {
    std::string scenarioText;  ///< gives the same scenario again

    GapReport() = default;
    /// Any study is a report whose scenario text is still to come.
    GapReport(GapStudy study) : GapStudy(std::move(study)) {}

    /// Returns what the reader should know about the period; empty when it begins at no gap.
    Message periodRemark(const ReadingStyle& style = plainStyle()) const;
};

/// Returns one JSON object, dimensionless, with the scales that lead to SI.
std::string gapJson(const GapReport& report);

/// Returns the curve as CSV: gap and all outputs, kinks included. SI needs a dimensional scenario.
std::string gapCsv(const GapReport& report, OutputUnits units);

/// Returns the table of the statistics, which must be there: a line of titles, then one for each of them.
TextGrid gapGrid(const GapReport& report, const ReadingStyle& style = plainStyle());

/// Returns remarks on the statistics, which must be there, a sentence or most of one each; the last states
/// their errors.
std::vector<std::string> gapRemarks(const GapReport& report, const ReadingStyle& style = plainStyle());

/// Returns table and remarks, and how long the study took.
std::string gapText(const GapReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
