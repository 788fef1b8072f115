// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts about many blows.
#pragma once

#include <vector>

#include "core/model/alerts.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Causes of alerts that are not part of a result.
struct AlertCauses {
    double lateShare = 0;  ///< largest impulse of a face after its first separation, of the hammer momentum
    double rounding = 0;   ///< of the frequency, as a share of it
    bool hasMachine = false;  ///< a body on a damper
};

std::vector<Alert> drillingAlerts(const DrillingResult& result, const AlertCauses& causes);

}  // namespace drillwave
