// SPDX-License-Identifier: GPL-3.0-or-later
// Problems of a sweep, found before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// Returns the problems of a sweep, each a line: two axes of one quantity, too many axes or points, outputs
/// that such scenarios do not have, no corner of the grid that is a scenario (AxisScenario). Empty if it can
/// run; points that are no scenario then have no result.
std::vector<Message> problemsOf(const Sweep& sweep);

}  // namespace drillwave
