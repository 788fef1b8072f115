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
/// omits. The source of a value is the comment after it, else the built-in preset that the scenario follows.
/// For omitted values it is "assumed by the program".
std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text);

/// Returns the sections of hammer and drill string as the text gives them, with their sources; none for a
/// uniform rod. A source is the comments after the values, else the comment after the list, else the preset.
std::vector<ReportSection> sectionsOf(const Scenario& scenario, std::string_view text);

}  // namespace drillwave
