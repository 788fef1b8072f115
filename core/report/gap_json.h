// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap for programs.
#pragma once

#include <string>

#include "core/report/gap_report.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// One JSON object, dimensionless, with the scales that lead to SI.
std::string gapJson(const GapReport& report);

/// The curve: gap and all outputs, kinks included. SI needs a dimensional scenario.
std::string gapCsv(const GapReport& report, OutputUnits units);

}  // namespace drillwave
