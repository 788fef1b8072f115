// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap as text for people.
#pragma once

#include <string>
#include <vector>

#include "core/report/gap_report.h"
#include "core/report/report_text.h"

namespace drillwave {

/// The table of the statistics: a line of titles, then one for each of them. They must be there.
TextGrid gapGrid(const GapReport& report, const ReadingStyle& style = plainStyle());

/// What else there is to say of them, a sentence or most of one each; the last tells their errors. Likewise.
std::vector<std::string> gapRemarks(const GapReport& report, const ReadingStyle& style = plainStyle());

/// All of it, and how long it took.
std::string gapText(const GapReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
