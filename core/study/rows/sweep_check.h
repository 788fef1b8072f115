// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a sweep before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// Returns the problems of a sweep, one message each; empty if the sweep can run. Problems are two axes of
/// one quantity, too many axes or points, and outputs that such scenarios do not have. A grid is also a
/// problem if none of its corners is a valid scenario (see AxisScenario). Single invalid points are no
/// problem: they have no result.
std::vector<Message> problemsOf(const Sweep& sweep);

}  // namespace drillwave
