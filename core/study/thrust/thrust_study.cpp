// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_study.h"

#include <algorithm>
#include <cassert>

#include "core/blow/feed_estimate.h"
#include "core/blow/impact_summary.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

/// Two pieces of work as one, half of the progress each.
class HalfProgress {
  public:
    explicit HalfProgress(const GapProgress& whole) : m_whole(whole) {}
    GapProgress from(double before) const {
        return [whole = m_whole, before](double done) {
            if (whole) whole(before + done / 2);
        };
    }

  private:
    GapProgress m_whole;
};

}  // namespace

Message thrustRefusal(const Scenario& scenario) {
    Message problem = invalidity(scenario);
    return problem.isEmpty() ? thrustProblem(scenario) : problem;
}

std::optional<double> ThrustStudy::margin() const {
    return feed.margin();
}

ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop, const GapProgress& progress,
                        long mostPieces, const WorkLimits& limits) {
    MethodSolver solver(limits);
    if (auto ofString = studyStringThrust(scenario, NetworkAccuracy::sure, solver, stop))
        return *std::move(ofString);
    ThrustStudy study;
    study.reason = thrustRefusal(scenario);
    if (!study.reason.isEmpty()) return study;
    const Problem problem = problemOf(scenario);
    const Impact impact = solver.solve(problem, Detail::cor, {}, stop);
    if (impact.outcome != Outcome::rebounded) {
        study.stopped = stop.stop_requested();
        study.reason = impact.reason;
        study.hindrance = impact.hindrance;
        return study;
    }
    const HalfProgress half(progress);
    const auto isKnown = [&study](const GapRebound& rebound) {
        study.stopped |= rebound.stopped;
        study.reason = rebound.reason;
        return rebound.known();
    };
    const GapCurve rock = rockCurve(problem, stop, half.from(0), mostPieces);
    GapRebounds& rebounds = study.rebounds.emplace();
    rebounds.quantile = quantileOf(rock);
    if (!isKnown(rebounds.quantile)) return study;
    rebounds.worst = worstOf(elasticCurve(problem, stop, half.from(0.5), mostPieces));
    if (!isKnown(rebounds.worst)) return study;

    study.feed = *feedEstimate(scenario, {impact.cor, impact.corError}, 1, rebounds.known());
    if (const auto force = study.feed.effective()) {
        const double served = *force / study.feed.balance - 1;  // up to which e
        study.shareFull = 1 - shareAbove(rock, served).value;
    }
    return study;
}

std::optional<ThrustStudy> studyStringThrust(const Scenario& scenario, NetworkAccuracy accuracy,
                                             MethodSolver& solver, const std::stop_token& stop) {
    if (gapPeriod(scenario)) return std::nullopt;
    ThrustStudy study;
    study.reason = thrustRefusal(scenario);
    if (!study.reason.isEmpty()) return study;
    const auto [problem, impact] = solver.solveString(scenario, {.accuracy = accuracy, .wants = {}}, stop);
    study.stopped = stop.stop_requested();
    study.reason = impact.reason;
    study.hindrance = impact.hindrance;
    if (study.stopped || !study.reason.isEmpty()) return study;
    const ImpactSummary summary = summarize(impact, problem);
    study.transferred = summary.transferred;
    study.feed = *feedEstimate(scenario, {summary.cor, summary.corError}, study.transferred);
    return study;
}

}  // namespace drillwave
