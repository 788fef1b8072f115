// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap with all that is reported about them.
#pragma once

#include <string>
#include <utility>

#include "core/study/gap/gap_study.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// All that is reported.
struct GapReport : GapStudy {
    std::string scenarioText;  ///< gives the same scenario again

    GapReport() = default;
    /// Any study is a report whose scenario text is still to come.
    GapReport(GapStudy study) : GapStudy(std::move(study)) {}

    /// What the reader should know about the period, empty when it begins at no gap.
    Message periodRemark(const ReadingStyle& style = plainStyle()) const;
};

}  // namespace drillwave
