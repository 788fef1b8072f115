// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_study.h"

#include <algorithm>
#include <chrono>

#include "core/model/blow_traits.h"
#include "core/model/validation.h"
#include "core/text/number_text.h"

namespace drillwave {

Message gapProblem(const Scenario& scenario, const std::optional<NormalGap>& normal) {
    if (Message problem = invalidity(scenario); !problem.isEmpty()) return problem;
    if (!gapHasPeriod(scenario))
        return translatable("all gaps can be studied only for uniform rods (`drillwave: 1`)");
    const auto isGap = [](const NormalGap& gap) {
        return gap.mean >= 0 && std::isfinite(gap.mean) && gap.deviation >= NormalGap::leastDeviation &&
               gap.deviation <= NormalGap::mostDeviation;
    };
    if (!normal || isGap(*normal)) return {};
    return {translatable("a normal gap needs a mean of at least 0 and a deviation from %1 to %2 [d0]"),
            {formatNumber(NormalGap::leastDeviation), formatNumber(NormalGap::mostDeviation)}};
}

GapStudy studyGap(const Scenario& scenario, const std::optional<NormalGap>& normal,
                  const std::stop_token& stop, const GapProgress& progress, long mostPieces) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    if (Message problem = gapProblem(scenario, normal); !problem.isEmpty()) {
        GapStudy refused{.scenario = scenario, .curve = {}, .normal = normal, .statistics = {}};
        refused.curve.reason = std::move(problem);
        return refused;
    }
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
