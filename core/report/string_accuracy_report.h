// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time for a drill string, told to people and to programs.
#pragma once

#include <string>

#include "core/model/scenario.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

/// A table for people, with what its columns mean.
std::string stringAccuracyText(const Scenario& scenario, const StringAccuracy& accuracy);

/// One JSON object, with the text that gives the scenario again.
std::string stringAccuracyJson(const std::string& scenarioText, const StringAccuracy& accuracy);

/// One row for each method and size of cell.
std::string stringAccuracyCsv(const StringAccuracy& accuracy);

}  // namespace drillwave
