// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap told to people.
#pragma once

#include <string>

#include "core/report/gap_report.h"

namespace drillwave {

/// A table, forces and gaps in the units of a dimensional scenario.
std::string gapText(const GapReport& report);

}  // namespace drillwave
