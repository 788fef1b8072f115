// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap with all that is reported about them.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/model/scenario.h"
#include "core/study/gap/gap_statistics.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// All that is reported.
struct GapReport {
    Scenario scenario;
    GapCurve curve;
    std::optional<NormalGap> normal;
    GapStatistics statistics;
    double runTime = 0;        ///< [s]
    std::string scenarioText;  ///< gives the same scenario again

    /// What the reader should know about the period, empty when it begins at no gap.
    std::string periodRemark(const ReadingStyle& style = plainStyle()) const;
};

/// Follows all outputs over the gap and takes the statistics, all but scenarioText. The gap of the scenario
/// does not matter. Statistics are there where the curve is complete; it takes at most `mostPieces`.
GapReport studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                   const std::stop_token& stop = {}, const GapProgress& progress = {},
                   long mostPieces = anyNumberOfPieces);

}  // namespace drillwave
