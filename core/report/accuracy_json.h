// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time for programs.
#pragma once

#include <string>

#include "core/model/scenario.h"
#include "core/study/proof/accuracy.h"

namespace drillwave {

/// One JSON object, with the text that gives the scenario again; numbers that there are none of are null.
std::string accuracyJson(const Scenario& scenario, const std::string& scenarioText, const Accuracy& accuracy);

/// One row for each method and resolution; empty cells where there is no number.
std::string accuracyCsv(const Accuracy& accuracy);

}  // namespace drillwave
