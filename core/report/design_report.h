// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs with what is reported about it: text, JSON and CSV.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_text.h"
#include "core/study/design/design_study.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// All that is reported. There is a robust best.
struct DesignReport {
    DesignStudy study;
    DesignFindings findings;
    std::string scenarioText;  ///< gives the same base again
    double runTime = 0;        ///< [s]
};

/// Returns what was varied, the best designs, ties, Pareto set, indices, worst cases and remarks, in this
/// order.
std::string designText(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Returns sentences on the question: uncertain inputs, choices, designs and samples.
std::vector<Message> designQuestionSentences(const DesignReport& report,
                                             const ReadingStyle& style = plainStyle());
/// Returns sentences on the answer: the cost of the robust best, worst cases, remarks.
std::vector<Message> designAnswerSentences(const DesignReport& report,
                                           const ReadingStyle& style = plainStyle());

/// Number of designs up to which designsGrid() has all of them.
inline constexpr std::size_t mostShownDesigns = 24;

/// Returns a line of titles and a line for each design: its marks, its choices, and its aims without and with
/// scatter. If there are more than mostShownDesigns, only those with a mark.
TextGrid designsGrid(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Returns one JSON object, SI or dimensionless as the scenario is.
std::string designJson(const DesignReport& report);

/// Return a row for each design, or for those of the Pareto set only. The columns of the choices, and what
/// keeps the energy, set a design again.
std::string designsCsv(const DesignReport& report);
std::string paretoCsv(const DesignReport& report);
/// A row for each output and uncertain number.
std::string sensitivityCsv(const DesignReport& report);
/// A row for each aim, its keys first: a table of cases of the base.
std::string worstCsv(const DesignReport& report);

}  // namespace drillwave
