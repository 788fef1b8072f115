// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts about a sequence of blows.
#pragma once

#include <vector>

#include "core/model/alerts.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Values from which alerts are derived but which are not part of a result.
struct AlertCauses {
    /// Largest impulse on a struck face after its first separation from the hammer, as a share of the hammer
    /// momentum.
    double lateShare = 0;
    /// Relative change of the blow frequency by rounding to whole time steps; either sign.
    double rounding = 0;
    bool hasMachine = false;  ///< whether the machine is modelled as a body on a damper
};

/// Returns the alerts about a sequence of blows, from its result and further causes.
std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes);

}  // namespace drillwave
