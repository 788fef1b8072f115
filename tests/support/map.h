// SPDX-License-Identifier: GPL-3.0-or-later
// Map of a result over two parameters, with axes as on the command line.
#pragma once

#include <string>

#include "core/study/map/map.h"

namespace drillwave::test {

/// Returns the study of a map; axes are given as "beta=0.1:5:4:log".
inline MapStudy mapOf(const Scenario& base, const std::string& x, const std::string& y,
                      const char* output = "cor", OutputUnits units = OutputUnits::dimensionless) {
    return {.base = base,
            .x = parseAxis(x).axis,
            .y = parseAxis(y).axis,
            .output = chooseOutputs(output, units).columns.front()};
}

}  // namespace drillwave::test
