// SPDX-License-Identifier: GPL-3.0-or-later
// Studies that a report contains if they are wanted, and their sections in its page.
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

/// Names of the studies for `report --with`, those of their commands.
inline constexpr std::string_view drillStudyName = "drill", designStudyName = "design";
inline constexpr std::array reportStudyNames{drillStudyName, designStudyName};

/// Finished studies of the scenario of a report; nullptr where there is none.
struct ReportStudies {
    std::shared_ptr<const DrillingResult> drilling;
    std::shared_ptr<const DrillingScan> scan;    ///< has points
    std::shared_ptr<const DesignReport> design;  ///< has a robust best; its texts may be empty
};

/// Returns the sections of the studies: for continuous drilling its means with their errors, for a scan its
/// best value, for a design study the answer and the best designs. Empty without studies.
std::string studiesHtml(const ReportStudies& studies, const ReportElements& page);

}  // namespace drillwave
