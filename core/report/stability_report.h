// SPDX-License-Identifier: GPL-3.0-or-later
// Report of the checks of stiff and extreme cases, as text, CSV and JSON.
#pragma once

#include <string>

#include "core/study/proof/stability.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// A line for each kind of case, the worst value of each measure with its mark and where it is, and a line
/// for each case that failed.
std::string stabilityText(const StabilityReport& report, const ReadingStyle& style = plainStyle());

/// Returns one JSON object with all cases, which took `runTime` [s]; null where a check does not apply.
std::string stabilityJson(const StabilityReport& report, double runTime);

/// One row for each case; empty cells where a check does not apply.
std::string stabilityCsv(const StabilityReport& report);

}  // namespace drillwave
