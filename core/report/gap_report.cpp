// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include <algorithm>
#include <chrono>

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

GapReport studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                   const std::stop_token& stop, const GapProgress& progress, long mostPieces) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const Problem problem = problemOf(scenario);
    const double period = gapPeriodStart(problem);
    const double start = normal ? std::min(lowestGap(*normal), period) : period;
    GapReport report{.scenario = scenario,
                     .curve = gapCurve(problem, start, Detail::events, stop, progress, mostPieces),
                     .normal = normal,
                     .statistics = {},
                     .runTime = 0,
                     .scenarioText = {}};
    if (report.curve.isComplete()) report.statistics = gapStatistics(report.curve, normal);
    report.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return report;
}

}  // namespace drillwave
