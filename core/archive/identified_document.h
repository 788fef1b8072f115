// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario file with the rock that was identified from records.
#pragma once

#include <string>

#include "core/report/identify_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the document with the identified rock. A comment after each identified value of the rock gives its
/// source and interval; everything else in the text remains. If the text has an unusual layout, it is
/// rewritten without these comments.
ScenarioDocument identifiedDocument(const IdentifyReport& report, ScenarioDocument document);

}  // namespace drillwave
