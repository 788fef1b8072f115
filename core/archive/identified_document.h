// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario with the rock that records show, as a file.
#pragma once

#include <string>

#include "core/report/identify_report.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the document with the rock as identified and its text, in which a comment behind each value of the
/// rock gives its source and interval; everything else stays as it was.
ScenarioDocument identifiedDocument(const IdentifyReport& report, ScenarioDocument document);

}  // namespace drillwave
