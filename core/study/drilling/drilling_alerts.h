// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be noticed of many blows.
#pragma once

#include <vector>

#include "core/model/alerts.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// What a result does not hold itself.
struct AlertCauses {
    double lateShare = 0;  ///< most that passed a face after its first separation, of the hammer's momentum
    double rounding = 0;   ///< of the frequency, as a share of it
    bool hasMachine = false;  ///< a body on a damper
};

std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes);

}  // namespace drillwave
