// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a blow as a page of HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/report/blow_report.h"
#include "core/report/report_elements.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// One of its plots.
struct ReportPicture {
    std::string name;     ///< "blow"
    std::string caption;  ///< a sentence
    std::string source;   ///< of <img>: a data: URI, or a name that the printer of the page knows
};

/// The name of the one that shows the sections of a string.
inline constexpr std::string_view stringPicture = "string";

/// Lines of the scenario on paper: two pages of small ones.
inline constexpr std::size_t mostPaperLines = 180;

/// Title with the head of the report, what is to be done about the feed, the first of the pictures, verdict,
/// alerts, results, studies of the blow and of ReportStudies, inputs with sources, the other pictures,
/// scenario, and last how well it is solved; no time and no place but those of the head. Numbers are in the
/// style of the reader. On the screen each number stands in full in `data-value` of its cell, and a page
/// without pictures says that they were left out by --no-plots. The blow must be solved.
std::string reportHtml(const BlowReport& report, const std::vector<ReportPicture>& pictures,
                       ReportMedium medium, const ReadingStyle& style = plainStyle(),
                       std::size_t paperLines = mostPaperLines);

/// Version, method, title and scenario as JSON, from the top of such a page for the screen; empty where there
/// are none.
std::string_view reportRecord(std::string_view html);

/// The title of the report, for a heading and the properties of a file.
std::string reportTitle(const BlowReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
