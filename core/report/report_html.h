// SPDX-License-Identifier: GPL-3.0-or-later
// Report on a blow as an HTML page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/report/blow_report.h"
#include "core/report/report_elements.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Plot in the page of a report.
struct ReportPicture {
    std::string name;     ///< name of the plot, such as "blow"
    std::string caption;  ///< caption, one sentence
    /// Source of the <img> element: a data: URI, or a name that the document on paper (QTextDocument)
    /// resolves.
    std::string source;
};

/// Name of the picture that shows the sections of the drill string.
inline constexpr std::string_view stringPicture = "string";

/// Default maximum number of lines of the scenario file in a printed report, about two pages of small type.
inline constexpr std::size_t mostPaperLines = 180;

/// Returns the report of a solved blow as an HTML page, with numbers in the style of the reader.
/// The order is: title and head, recommendation on the feed force, first picture, verdict, alerts, results,
/// studies. Then inputs with their sources, other pictures, scenario and numerical accuracy follow.
/// The page has no date or place except those in BlowReport::head. On the screen, each table cell has its
/// full number in `data-value`. If there are no pictures, the page for the screen says that --no-plots
/// omitted them.
std::string reportHtml(const BlowReport& report, const std::vector<ReportPicture>& pictures,
                       ReportMedium medium, const ReadingStyle& style = plainStyle(),
                       std::size_t paperLines = mostPaperLines);

/// Returns the JSON at the top of a report page for the screen, with version, method, title and scenario. The
/// program uses it to open the scenario of the report. Empty if the page has none.
std::string_view reportRecord(std::string_view html);

/// Returns the title of the report, for a heading and the properties of a file.
std::string reportTitle(const BlowReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
