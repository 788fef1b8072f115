// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/study.h"

#include "core/report/gap_report.h"
#include "core/report/thrust_report.h"

namespace drillwave {

std::vector<const Study*> studies() {
    return {&gapStudy(), &thrustStudy()};
}

}  // namespace drillwave
