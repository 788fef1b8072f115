// SPDX-License-Identifier: GPL-3.0-or-later
// The study of all gaps between bit and rock, and its statistics as text, JSON, CSV and figure.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_text.h"
#include "core/report/study.h"
#include "core/study/gap/gap_study.h"
#include "core/study/rows/output_column.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// `drillwave gap` and the page COR–gap: what a gap that nobody controls does to a blow (paper, Fig. 8).
const Study& gapStudy();

/// Returns what the reader should know about the period; empty when it begins at no gap.
Message periodRemark(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns one JSON object, dimensionless, with the scales that lead to SI; `scenarioText` gives the same
/// scenario again.
std::string gapJson(const GapStudy& study, const std::string& scenarioText);

/// Returns the curve as CSV: gap and all outputs, kinks included. SI needs a dimensional scenario.
std::string gapCsv(const GapStudy& study, OutputUnits units);

/// Returns the table of the statistics, which must be there: a line of titles, then one for each of them.
TextGrid gapGrid(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns remarks on the statistics, which must be there, a sentence or most of one each; the last states
/// their errors.
std::vector<std::string> gapRemarks(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns table and remarks, and how long the study took.
std::string gapText(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns an output over one period of the gap, with its distribution beside it, of a complete study.
StudyFigure gapFigure(const GapStudy& study, GapOutput output);

/// Returns the same of a first look.
StudyFigure gapPreviewFigure(const Scenario& scenario, const std::vector<GapSample>& samples,
                             GapOutput output);

}  // namespace drillwave
