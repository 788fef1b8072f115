// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_study.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/blow/thrust.h"
#include "core/model/scales.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

namespace {

constexpr std::size_t index(ThrustCase which) {
    return static_cast<std::size_t>(which);
}

ThrustNeed needOf(const Scenario& scenario, const Estimate& cor) {
    const FeedVerdict verdict = *judgeFeed(scenario, cor.value);
    ThrustNeed need{.cor = cor,
                    .thrust = verdict.fullRate,
                    .thrustUndamped = verdict.returned,
                    .margin = {},
                    .frequencyLimit = {},
                    .feed = verdict.feed};
    if (verdict.installed) {
        need.margin = *verdict.installed / need.thrust - 1;
        need.frequencyLimit = *scenario.drill.blowFrequency * *verdict.installed / need.thrust;
    }
    return need;
}

/// Both curves over the gap, half of the progress each.
struct Curves {
    GapCurve rock;     ///< as it is
    GapCurve elastic;  ///< γ = 1, from no gap on
};

Curves curvesOf(const Problem& problem, const std::stop_token& stop, const GapProgress& progress) {
    const auto half = [&](double before) {
        return [&progress, before](double done) {
            if (progress) progress(before + done / 2);
        };
    };
    Problem elastic = problem;
    elastic.law.gamma = 1;
    return {gapCurve(problem, Detail::cor, stop, half(0)),
            gapCurve(elastic, 0, Detail::cor, stop, half(0.5))};
}

}  // namespace

std::string_view name(ThrustCase which) {
    constexpr std::array<std::string_view, thrustCaseCount> names{"scenario", "gap_95_percent", "rigid_rock",
                                                                  "elastic_worst_gap"};
    return names[index(which)];
}

const ThrustNeed& ThrustStudy::largestNeed() const {
    return *std::ranges::max_element(needs, {}, &ThrustNeed::thrust);
}

ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop, const GapProgress& progress) {
    assert(thrustProblem(scenario).empty());
    const Problem problem = problemOf(scenario);
    ThrustStudy study;
    const Impact impact = ExactSolver().solve(problem, Detail::cor, stop);
    if (impact.outcome != Outcome::rebounded) {
        study.stopped = stop.stop_requested();
        study.reason = impact.reason;
        return study;
    }
    const Curves curves = curvesOf(problem, stop, progress);
    study.stopped = curves.rock.stopped || curves.elastic.stopped;
    for (const GapCurve* curve : {&curves.rock, &curves.elastic})
        if (!curve->isComplete()) study.reason = curve->reason;
    if (study.stopped || !study.reason.empty()) return study;

    const GapStatistics statistics = gapStatistics(curves.rock);
    const auto set = [&](ThrustCase which, const Estimate& cor) {
        study.needs[index(which)] = needOf(scenario, cor);
    };
    set(ThrustCase::scenario, {impact.cor, impact.corError});
    set(ThrustCase::gapQuantile, statistics.of(GapOutput::cor).uniform.quantiles.back());
    set(ThrustCase::rigidRock, {1, 0});
    set(ThrustCase::elasticWorst, largestCor(curves.elastic));
    study.verdict = *judgeFeed(scenario, impact.cor);
    if (scenario.drill.thrust) {
        const double served = *scenario.drill.thrust / study.verdict.balance - 1;  // up to which e
        study.shareFull = 1 - shareAbove(curves.rock, served).value;
    }
    return study;
}

}  // namespace drillwave
