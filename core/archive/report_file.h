// SPDX-License-Identifier: GPL-3.0-or-later
// Report on a scenario, with its values as its file gives them.
#pragma once

#include <stop_token>
#include <string_view>
#include <vector>

#include "core/report/blow_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the report on a scenario, see studyReport(), together with the scenario and the sources of its
/// values. Throws ScenarioError if the scenario cannot be written as a complete text, see
/// completeScenarioText().
BlowReport reportOn(const ScenarioDocument& document, const std::stop_token& stop = {},
                    const GapProgress& progress = {}, const WorkLimits& limits = {});

/// Returns the values given in the text of a scenario file, in the order of the file, and values that it
/// omits, all with their sources. The source is the comment after the value, else the built-in preset that
/// the scenario follows. Without both it is "not stated", or "assumed by the program" for omitted values.
std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text);

/// Returns the sections that the text of a scenario file lists for hammer and drill string, with the source
/// of each. Empty for a uniform rod. A source is the comments after the values, else the comment after the
/// list, else the preset.
std::vector<ReportSection> sectionsOf(const Scenario& scenario, std::string_view text);

}  // namespace drillwave
