// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep over parameters, with axes as on the command line.
#pragma once

#include <initializer_list>

#include "core/study/rows/sweep.h"

namespace drillwave::test {

/// Returns a sweep; axes are given as "beta=0.1:5:4:log", outputs as "cor,peak_force".
inline Sweep sweepOf(const Scenario& base, std::initializer_list<const char*> axes, const char* outputs,
                     OutputUnits units = OutputUnits::dimensionless) {
    Sweep sweep{.base = base, .axes = {}, .columns = chooseOutputs(outputs, units).columns, .shard = {}};
    for (const char* axis : axes) sweep.axes.push_back(parseAxis(axis).axis);
    return sweep;
}

}  // namespace drillwave::test
