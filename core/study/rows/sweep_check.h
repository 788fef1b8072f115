// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a sweep before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// Returns the problems of a sweep, one message each; empty if it can run. Problems are two axes of one
/// quantity, too many axes or points, and outputs that such scenarios do not have. Another is a grid without
/// any corner that is a valid scenario (see AxisScenario). Single invalid points are allowed and have no
/// result.
std::vector<Message> problemsOf(const Sweep& sweep);

}  // namespace drillwave
