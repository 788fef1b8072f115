// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/blow/impact_summary.h"
#include "core/model/validation.h"
#include "core/text/handy_text.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

Message whyNoPeriod(const Scenario& scenario) {
    if (gapPeriod(scenario)) return {};
    return translatable(
        "is a drill string, and this command solves uniform rods alone (`drillwave: 1`); "
        "`drillwave curve FILE --along bit_rock.gap=0mm:2mm` follows a string along its gap");
}

Message gapProblem(const Scenario& scenario, const std::optional<NormalGap>& normal) {
    if (Message problem = invalidity(scenario); !problem.isEmpty()) return problem;
    if (Message problem = whyNoPeriod(scenario); !problem.isEmpty()) return problem;
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

void previewGaps(const Scenario& scenario, const std::stop_token& stop,
                 const std::function<void(const std::vector<GapSample>&)>& show) {
    constexpr long worthIt = 100'000;  // wave pieces of five blows: the whole curve takes seconds
    constexpr int mostParts = 32;
    Problem problem = problemOf(scenario);
    const double start = gapPeriodStart(problem);
    if (!std::isfinite(start)) return;
    ExactSolver solver;
    std::vector<GapSample> samples;
    long pieces = 0;
    const auto solve = [&](double gap) {
        if (stop.stop_requested()) return;
        problem.gap = gap;
        const Impact impact = solver.solve(problem, Detail::events, stop);
        pieces += impact.pieces;
        if (!impact.isSolved()) return;
        const ImpactSummary summary = summarize(impact, problem);
        const GapSample sample{gap, {summary.cor, summary.peakForce, summary.energy.rockWork}};
        samples.insert(std::ranges::upper_bound(samples, gap, {}, &GapSample::gap), sample);
    };
    solve(start);
    solve(start + 1);
    for (int parts = 2; parts <= mostParts; parts *= 2) {
        for (int i = 1; i < parts; i += 2) solve(start + double(i) / parts);
        if (stop.stop_requested()) return;
        if (parts < 4) continue;
        if (pieces < worthIt) return;
        show(samples);
    }
}

}  // namespace drillwave
