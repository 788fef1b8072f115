// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs with all that is reported about it.
#pragma once

#include <string>

#include "core/study/design/design_study.h"

namespace drillwave {

/// All that is reported. There is a robust best.
struct DesignReport {
    DesignStudy study;
    DesignFindings findings;
    std::string scenarioText;  ///< gives the same base again
    double runTime = 0;        ///< [s]
};

}  // namespace drillwave
