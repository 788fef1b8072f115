// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_study.h"

#include <algorithm>
#include <chrono>

namespace drillwave {

GapStudy studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                  const std::stop_token& stop, const GapProgress& progress, long mostPieces) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const Problem problem = problemOf(scenario);
    const double period = gapPeriodStart(problem);
    const double start = normal ? std::min(lowestGap(*normal), period) : period;
    GapStudy study{.scenario = scenario,
                   .curve = gapCurve(problem, start, Detail::events, stop, progress, mostPieces),
                   .normal = normal,
                   .statistics = {},
                   .runTime = 0};
    if (study.curve.isComplete()) study.statistics = gapStatistics(study.curve, normal);
    study.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return study;
}

}  // namespace drillwave
