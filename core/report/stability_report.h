// SPDX-License-Identifier: GPL-3.0-or-later
// Report of the tests with stiff and extreme cases, as text, CSV and JSON.
#pragma once

#include <string>

#include "core/study/proof/stability.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the report as text. It has one line for each kind of test case, then for each check the worst
/// value, its limit and the case. One line for each failed case follows.
std::string stabilityText(const StabilityReport& report, const ReadingStyle& style = plainStyle());

/// Returns one JSON object with all test cases; null where a check does not apply. `runTime` is the computing
/// time [s].
std::string stabilityJson(const StabilityReport& report, double runTime);

/// Returns one CSV row for each test case; cells are empty where a check does not apply.
std::string stabilityCsv(const StabilityReport& report);

}  // namespace drillwave
