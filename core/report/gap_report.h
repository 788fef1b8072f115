// SPDX-License-Identifier: GPL-3.0-or-later
// Study of all gaps between bit and rock: its statistics as text, JSON, CSV and figure.
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

/// Returns the study behind `drillwave gap` and the page COR–gap: the effect of an uncontrolled gap on a blow
/// (paper, Fig. 8).
const Study& gapStudy();

/// Returns a note about the gap from which results repeat periodically as the gap grows. Empty if they repeat
/// from gap 0 on. If results do not depend on the gap, the note says so.
Message periodRemark(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns the study as one JSON object, dimensionless and with the scales for conversion to SI units. It
/// contains `scenarioText`, the text of a scenario file, from which the study can be reproduced.
std::string gapJson(const GapStudy& study, const std::string& scenarioText);

/// Returns the curve as CSV: the gap and all outputs, including points at kinks. SI units require a scenario
/// with units.
std::string gapCsv(const GapStudy& study, OutputUnits units);

/// Returns a table of the statistics: headings, then one line for each statistic, such as the mean. Requires
/// a complete curve, for which there are statistics.
TextGrid gapGrid(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns notes on the statistics, about one sentence each; the last one states their errors. Requires that
/// the statistics exist.
std::vector<std::string> gapRemarks(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns the study as text: the table, the notes and the computing time.
std::string gapText(const GapStudy& study, const ReadingStyle& style = plainStyle());

/// Returns a figure of an output over one period of the gap, with the distribution of the output beside it.
/// Requires a complete study.
StudyFigure gapFigure(const GapStudy& study, GapOutput output);

/// Returns a preview of gapFigure() from a few solved gaps: an output over one period of the gap, without its
/// distribution.
StudyFigure gapPreviewFigure(const Scenario& scenario, const std::vector<GapSample>& samples,
                             GapOutput output);

}  // namespace drillwave
