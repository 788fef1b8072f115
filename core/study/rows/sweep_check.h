// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a sweep unusable, found before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// What makes a sweep unusable, each a line that names the axis value: two axes of one quantity, a parameter
/// that has no meaning in any point, a point that is no valid scenario. Empty when it can run.
std::vector<std::string> problemsOf(const Sweep& sweep);

}  // namespace drillwave
