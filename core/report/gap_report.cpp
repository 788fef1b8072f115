// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

namespace drillwave {

std::string GapReport::periodRemark(const ReadingStyle& style) const {
    if (!curve.dependsOnGap)
        return "The reference case does not depend on the gap: it only shifts the time of contact.";
    if (curve.periodStart == 0) return {};
    return "The hammer still pushes when its first reflection is back: results have a period in the gap only "
           "from a gap of " +
           style.number(curve.periodStart) +
           " d0 on, and the statistics are over the period that begins there.";
}

}  // namespace drillwave
