// SPDX-License-Identifier: GPL-3.0-or-later
// e over the gap of the pinned runs, laid over that of the scenario.
#pragma once

#include <memory>
#include <vector>

#include "core/study/gap/gap_curve.h"
#include "ui/job/study_job.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Scenarios without their gaps, which do not matter.
struct RunGapsQuestion {
    std::vector<Scenario> scenarios;
    bool operator==(const RunGapsQuestion&) const = default;
};

/// Results over the gap of a scenario.
struct RunGap {
    Scenario scenario;
    GapCurve curve;  ///< complete
};
using RunGaps = std::vector<std::shared_ptr<const RunGap>>;  ///< those that are solved so far

/// Follows scenarios along the gap, and keeps the curves of the last question for the next one. Called on one
/// thread at a time.
class RunGapsStudy {
  public:
    RunGaps operator()(const RunGapsQuestion& question, const StudyFeed<RunGaps>& feed);

  private:
    std::shared_ptr<RunGaps> m_known = std::make_shared<RunGaps>();  // of all copies
};

/// An output over gaps from 0 to `to`, which is as shown; shown values are the dimensionless ones times the
/// factors.
GraphData runGapCurve(const GapCurve& curve, GapOutput output, double gapFactor, double valueFactor,
                      double to);

}  // namespace drillwave
