// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a sweep unusable, found before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// What makes a sweep unusable, each a line: two axes of one quantity, too many axes or points, outputs that
/// such scenarios have not, no corner of the grid that is a scenario (AxisScenario). Empty when it can run; a
/// point that is none has no answer then.
std::vector<Message> problemsOf(const Sweep& sweep);

}  // namespace drillwave
