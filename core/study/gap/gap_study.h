// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a scenario over all gaps, and their statistics.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/model/scenario.h"
#include "core/study/gap/gap_statistics.h"
#include "core/text/message.h"

namespace drillwave {

struct GapStudy {
    Scenario scenario;
    GapCurve curve;
    std::optional<NormalGap> normal;
    GapStatistics statistics;  ///< where the curve is complete
    double runTime = 0;        ///< [s]

    /// Returns the statistics of an output under the distribution of the study: the scattered gap, or all
    /// gaps. Requires a complete curve.
    const GapSpread& spread(GapOutput output) const {
        const GapOutputStatistics& both = statistics.of(output);
        return normal ? *both.normal : both.uniform;
    }
};

/// Returns why results do not repeat over the gap of such a scenario; empty where they do.
Message whyNoPeriod(const Scenario& scenario);

/// Why there is no study of all gaps of a scenario; empty when there is.
Message gapProblem(const Scenario& scenario, const std::optional<NormalGap>& normal = {});

/// Follows all outputs over the gap and takes the statistics. The gap of the scenario does not matter. The
/// curve takes at most `mostPieces`. Where there is a gapProblem(), that is the reason of an empty curve.
GapStudy studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                  const std::stop_token& stop = {}, const GapProgress& progress = {},
                  long mostPieces = anyNumberOfPieces);

/// Outputs at one gap, in the order of GapOutput.
struct GapSample {
    double gap = 0;  ///< [d0]
    std::array<double, gapOutputCount> values{};
};

/// Solves blows at 5, 9, 17 and 33 even gaps of the period and shows all of them after each step, ascending.
/// Returns after the first five if these are solved so quickly that the whole curve only takes a moment, and
/// after a stop.
void previewGaps(const Scenario& scenario, const std::stop_token& stop,
                 const std::function<void(const std::vector<GapSample>&)>& show);

}  // namespace drillwave
