// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario file with the rock that was identified from records.
#pragma once

#include <string>

#include "core/report/identify_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the scenario document with the rock parameters that were identified from measured records. A
/// comment after each identified value gives its source and its interval of uncertainty; everything else in
/// the text remains. If the text has an unusual layout, it is rewritten without these comments.
ScenarioDocument identifiedDocument(const IdentifyReport& report, ScenarioDocument document);

}  // namespace drillwave
