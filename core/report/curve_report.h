// SPDX-License-Identifier: GPL-3.0-or-later
// A study along a parameter with all that is reported about it.
#pragma once

#include <string>

#include "core/study/curve/curve.h"

namespace drillwave {

/// All that is reported.
struct CurveReport {
    CurveStudy study;
    double runTime = 0;        ///< [s]
    std::string scenarioText;  ///< gives the same scenario again
};

}  // namespace drillwave
