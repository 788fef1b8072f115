// SPDX-License-Identifier: GPL-3.0-or-later
// The single blow that a march of many begins with.
#pragma once

#include <limits>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/problem.h"

namespace drillwave {

struct BlowAlone {
    Problem problem;  ///< with as many pieces of cones as the blow takes
    double cor = std::numeric_limits<double>::quiet_NaN();  ///< e at zero gap, where it was wanted and solved
};

/// Of a scenario with units. A march is of this problem to its last bit: so is whatever looks at it again.
BlowAlone blowAlone(const Scenario& scenario, bool wantsCor, const std::stop_token& stop);

}  // namespace drillwave
