// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

namespace drillwave {

Message GapReport::periodRemark(const ReadingStyle& style) const {
    if (!curve.dependsOnGap)
        return translatable(
            "The reference case does not depend on the gap: it only shifts the time of contact.");
    if (curve.periodStart == 0) return {};
    return {translatable("The hammer still pushes when its first reflection is back: results have a period "
                         "in the gap only from a gap of %1 d0 on, and the statistics are over the period "
                         "that begins there."),
            {style.number(curve.periodStart)}};
}

}  // namespace drillwave
