// SPDX-License-Identifier: GPL-3.0-or-later
// Report of a design study as text, JSON and CSV.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_text.h"
#include "core/study/design/design_study.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Contents of the report of a design study. Requires that a best design for uncertain rock exists.
struct DesignReport {
    DesignStudy study;
    DesignFindings findings;
    std::string scenarioText;  ///< scenario file that reproduces the base scenario
    double runTime = 0;        ///< computing time [s]
};

/// Returns the report as text. It begins with the recommendation and the question. Best and equally good
/// designs, Pareto set, Sobol indices, worst cases and warnings follow.
std::string designText(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Returns sentences that describe the question: uncertain inputs, design variables, numbers of designs and
/// samples.
std::vector<Message> designQuestionSentences(const DesignReport& report,
                                             const ReadingStyle& style = plainStyle());
/// Returns sentences that describe the result: the disadvantages of the best design for uncertain rock, worst
/// cases and warnings.
std::vector<Message> designAnswerSentences(const DesignReport& report,
                                           const ReadingStyle& style = plainStyle());

/// Maximum number of designs for which designsGrid() lists all designs.
inline constexpr std::size_t mostShownDesigns = 24;

/// Returns a table with headings and one line per design. A line has the marks of a design (such as best or
/// present) and its design variables. Its objectives without and with the scatter of the uncertain inputs
/// follow. With more than mostShownDesigns designs, only those with a mark are listed.
TextGrid designsGrid(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Returns the report as one JSON object; values are in SI units if the scenario has units, otherwise
/// dimensionless.
std::string designJson(const DesignReport& report);

/// Returns one CSV row for each design; paretoCsv() returns only the Pareto-optimal designs. The columns of
/// the design variables, and of the parameter that keeps the energy constant, are enough to set a design in a
/// scenario.
std::string designsCsv(const DesignReport& report);
std::string paretoCsv(const DesignReport& report);
/// Returns the Sobol indices as CSV, one row for each output and uncertain input.
std::string sensitivityCsv(const DesignReport& report);
/// Returns the worst cases as CSV, one row for each objective. The first columns are parameter keys, so that
/// the file can be used as a table of cases for the base scenario.
std::string worstCsv(const DesignReport& report);

}  // namespace drillwave
