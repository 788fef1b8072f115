// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs for people.
#pragma once

#include <string>

#include "core/report/design_report.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// From top to bottom what was varied, the best designs, ties, Pareto set, indices, worst cases, remarks.
std::string designText(const DesignReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
