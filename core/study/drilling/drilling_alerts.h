// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts about a sequence of blows.
#pragma once

#include <vector>

#include "core/model/alerts.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Numbers that decide, together with the result of a sequence of blows, which alerts the user gets.
struct AlertCauses {
    /// Largest impulse that the hammer gives the drill string after their first separation in a blow, as a
    /// share of the hammer momentum. A large share causes an alert.
    double lateShare = 0;
    /// Relative change of the blow frequency that results from rounding the interval between blows to whole
    /// time steps; positive or negative.
    double rounding = 0;
    bool hasMachine = false;  ///< whether the machine is modelled as a body on a damper
};

/// Returns the alerts for the user about a sequence of blows.
std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes);

}  // namespace drillwave
