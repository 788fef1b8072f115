// SPDX-License-Identifier: GPL-3.0-or-later
// Report on a scenario, with its values as its file gives them.
#pragma once

#include <stop_token>
#include <string_view>
#include <vector>

#include "core/report/blow_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the report on the blow of a scenario (studyReport()), with the text of the scenario and the
/// sources of its values. Throws ScenarioError if completeScenarioText() cannot write this text.
BlowReport reportOn(const ScenarioDocument& document, const std::stop_token& stop = {},
                    const GapProgress& progress = {}, const WorkLimits& limits = {});

/// Returns the values in the text of a scenario file, in its order, and the values that it omits, each with
/// its source. The source is the comment after the value, else the built-in preset that the scenario follows.
/// Otherwise it is "not stated", or "assumed by the program" for omitted values.
std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text);

/// Returns the sections of hammer and drill string in the text of a scenario file, each with the source of
/// its values. The source is the comments after the values, else the comment after the list, else the preset.
/// Empty for a uniform rod.
std::vector<ReportSection> sectionsOf(const Scenario& scenario, std::string_view text);

}  // namespace drillwave
