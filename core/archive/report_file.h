// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a scenario as it stands in its file.
#pragma once

#include <stop_token>
#include <string_view>
#include <vector>

#include "core/report/blow_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// studyReport() with the scenario itself and the sources of its values. Throws ScenarioError as
/// completeScenarioText() does.
BlowReport reportOn(const ScenarioDocument& document, const std::stop_token& stop = {},
                    const GapProgress& progress = {}, const WorkLimits& limits = {});

/// The values of a scenario as its text has them, in the order of a file. The source of each is the comment
/// behind it; without one, the built-in preset that the scenario follows; "assumed by the program" for a
/// value that the text leaves out.
std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text);

/// Returns the sections of a hammer and a string in the same way; none for a uniform rod. Their source also
/// includes remarks after the list that they are in.
std::vector<ReportSection> sectionsOf(const Scenario& scenario, std::string_view text);

}  // namespace drillwave
