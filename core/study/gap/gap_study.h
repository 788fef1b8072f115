// SPDX-License-Identifier: GPL-3.0-or-later
// Study of the results of a scenario over all gaps, and their statistics.
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
    GapStatistics statistics;  ///< statistics over the gap; only valid if the curve is complete
    double runTime = 0;        ///< computing time [s]

    /// Returns the statistics of an output under the normal distribution of the study, or with all gaps
    /// equally likely if it has none. Requires a complete curve.
    const GapSpread& spread(GapOutput output) const {
        const GapOutputStatistics& both = statistics.of(output);
        return normal ? *both.normal : both.uniform;
    }
};

/// Returns why the results of a scenario do not repeat periodically with growing gap, which is the case for
/// drill strings; empty if they do.
Message whyNoPeriod(const Scenario& scenario);

/// Returns an error message if a scenario cannot be studied over all gaps, or if `normal` is not a valid
/// distribution; empty if both are fine.
Message gapProblem(const Scenario& scenario, const std::optional<NormalGap>& normal = {});

/// Returns all outputs as functions of the gap, with their statistics. The gap of the scenario itself is
/// ignored. The work of all blows together is limited to `mostPieces` wave pieces (the solver's unit of
/// work). If gapProblem() returns a message, the curve is empty and has that message as its reason.
GapStudy studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                  const std::stop_token& stop = {}, const GapProgress& progress = {},
                  long mostPieces = anyNumberOfPieces);

/// Results of a blow at one gap, in the order of GapOutput.
struct GapSample {
    double gap = 0;  ///< dimensionless gap d/d0
    std::array<double, gapOutputCount> values{};
};

/// Passes quick previews of the curve over one period to `show`, to be drawn until the whole curve is
/// computed. They have 5, 9, 17 and 33 evenly spaced gaps, ascending. Gaps at which the blow is not solved
/// are left out. Passes nothing if the whole curve takes only a moment. Returns early after a stop request.
void previewGaps(const Scenario& scenario, const std::stop_token& stop,
                 const std::function<void(const std::vector<GapSample>&)>& show);

}  // namespace drillwave
