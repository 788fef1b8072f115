// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts about a sequence of blows.
#pragma once

#include <vector>

#include "core/model/alerts.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Numbers, in addition to a result, from which the alerts about a sequence of blows are derived.
struct AlertCauses {
    /// Largest impulse of the hammer on the string after their first separation in a blow, as a share of the
    /// hammer momentum. A large share causes an alert.
    double lateShare = 0;
    /// Relative change of the blow frequency because the interval between blows is rounded to whole time
    /// steps; positive or negative.
    double rounding = 0;
    bool hasMachine = false;  ///< whether the machine is modelled as a body on a damper
};

/// Returns the alerts about a sequence of blows, from its result and from further numbers in `causes`.
std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes);

}  // namespace drillwave
