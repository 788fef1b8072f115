// SPDX-License-Identifier: GPL-3.0-or-later
// Studies that a report contains on request, and their sections in its page.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/report/report_elements.h"

namespace drillwave {

struct DesignReport;
struct DrillingResult;
struct DrillingScan;

/// Names of the studies that `report --with` can add to a report, equal to the names of their commands.
inline constexpr std::string_view drillStudyName = "drill", designStudyName = "design";
inline constexpr std::array reportStudyNames{drillStudyName, designStudyName};

/// Studies that a report includes on request, all for the scenario of the report. A member is nullptr if its
/// study was not made.
struct ReportStudies {
    std::shared_ptr<const DrillingResult> drilling;
    /// Scan: sequences of blows for several values of a parameter; has at least one value.
    std::shared_ptr<const DrillingScan> scan;
    /// Report of a design study; nullptr if there was no such study or no best design. Its scenarioText may
    /// be empty, as the HTML sections do not use it.
    std::shared_ptr<const DesignReport> design;
};

/// Returns the studies as HTML sections; empty without studies. For a sequence of blows they list means with
/// errors, for a scan the best value. For a design study they list the result and the best designs.
std::string studiesHtml(const ReportStudies& studies, const ReportElements& page);

}  // namespace drillwave
