// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/thrust_curve.h"

#include <cassert>

#include "core/blow/feed_estimate.h"
#include "core/model/parameter_text.h"
#include "core/model/validation.h"
#include "core/numeric/ordered_work.h"
#include "core/study/thrust/thrust_study.h"

namespace drillwave {

namespace {

/// The base with that value, or why the point cannot even be tried.
struct ScenarioAt {
    Scenario scenario;
    Message obstacle;
};

ScenarioAt scenarioAt(const Scenario& base, const Parameter& parameter, double value) {
    ScenarioAt at{base, {}};
    if (!parameter.applies(base))
        at.obstacle = about(std::string(parameter.key), translatable("does not apply to this scenario"));
    else if (const Message problem = assignNumber(at.scenario, parameter, value); !problem.isEmpty())
        at.obstacle = {"%1 %2", {std::string(parameter.key), problem}};
    if (const auto problems = at.obstacle.isEmpty() ? validate(at.scenario) : std::vector<InputProblem>();
        !problems.empty())
        at.obstacle = problems.front().text;
    if (at.obstacle.isEmpty()) at.obstacle = readBackProblem(parameter, at.scenario, value);
    if (at.obstacle.isEmpty()) at.obstacle = thrustProblem(at.scenario);
    return at;
}

/// Whether all points are one blow at one gap or another, for which one thread is enough: it finds the rest
/// in its memory.
bool isOneBlow(const Scenario& base, const Parameter& parameter, std::span<const double> values) {
    const auto blowAt = [&](double value) -> std::optional<Problem> {
        const ScenarioAt at = scenarioAt(base, parameter, value);
        if (!at.obstacle.isEmpty()) return std::nullopt;
        Problem problem = problemOf(at.scenario);
        problem.gap = 0;
        return problem;
    };
    const std::optional<Problem> first = blowAt(values.front());
    return first && rodRefusal(*first).empty() && first == blowAt(values.back());
}

/// With what they keep from point to point.
struct PointSolvers {
    GapReboundFinder& finder;
    MethodSolver& solver;
};

ThrustPoint solvedPoint(const Scenario& scenario, double value, const PointSolvers& solvers,
                        const std::stop_token& stop) {
    ThrustPoint point{.value = value, .feed = {}, .reason = {}};
    if (const std::optional<ThrustStudy> study =
            studyStringThrust(scenario, NetworkAccuracy::quick, solvers.solver, stop)) {
        point.reason = study->stopped ? "stopped" : study->reason;
        if (point.reason.isEmpty()) point.feed = study->feed;
        return point;
    }
    const Problem problem = problemOf(scenario);
    const Impact impact = solvers.solver.solve(problem, Detail::cor, {}, stop);
    if (impact.outcome != Outcome::rebounded) {
        point.reason = impact.reason;
        return point;
    }
    const GapRebounds rebounds = solvers.finder.of(problem, stop);
    for (const GapRebound* rebound : {&rebounds.quantile, &rebounds.worst})
        if (!rebound->known()) point.reason = rebound->stopped ? "stopped" : rebound->reason;
    if (!point.reason.isEmpty()) return point;
    point.feed = *feedEstimate(scenario, {impact.cor, impact.corError}, 1, rebounds.known());
    return point;
}

ThrustPoint pointAt(const Scenario& base, const Parameter& parameter, double value,
                    const PointSolvers& solvers, const std::stop_token& stop) {
    ScenarioAt at = scenarioAt(base, parameter, value);
    if (!at.obstacle.isEmpty()) return {.value = value, .feed = {}, .reason = std::move(at.obstacle)};
    return solvedPoint(at.scenario, value, solvers, stop);
}

struct Chunk {
    double value = 0;
    ThrustPoint point;
};

}  // namespace

ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        int jobs, const std::stop_token& stop, const ThrustCurveProgress& progress,
                        const WorkLimits& limits) {
    ThrustCurve curve;
    if (values.empty()) return curve;
    if (isOneBlow(base, parameter, values)) jobs = 1;
    std::size_t next = 0;
    const auto fill = [&](Chunk& chunk) {
        if (next == values.size()) return false;
        chunk.value = values[next++];
        return true;
    };
    const auto makeWorker = [&] {
        return [&, finder = GapReboundFinder(), solver = MethodSolver(limits)](
                   Chunk& chunk, const std::stop_token& ending) mutable {
            chunk.point = pointAt(base, parameter, chunk.value, {finder, solver}, ending);
        };
    };
    const auto deliver = [&](Chunk& chunk) {
        curve.points.push_back(std::move(chunk.point));
        if (progress) progress(curve);
        return true;
    };
    curve.stopped = processInOrder<Chunk>(jobs, stop, fill, makeWorker, deliver) == WorkEnd::stopped;
    return curve;
}

ThrustCurve thrustAlong(const Scenario& base, const Parameter& parameter, std::span<const double> values,
                        GapReboundFinder& finder, const std::stop_token& stop,
                        const ThrustCurveProgress& progress) {
    ThrustCurve curve;
    MethodSolver solver;
    for (const double value : values) {
        ThrustPoint point = pointAt(base, parameter, value, {finder, solver}, stop);
        curve.stopped = stop.stop_requested();
        if (curve.stopped) return curve;
        curve.points.push_back(std::move(point));
        if (progress) progress(curve);
    }
    return curve;
}

ThrustPoint thrustPoint(const Scenario& scenario, double value, GapReboundFinder& finder,
                        const std::stop_token& stop) {
    if (Message refusal = thrustRefusal(scenario); !refusal.isEmpty())
        return {.value = value, .feed = {}, .reason = std::move(refusal)};
    MethodSolver solver;
    return solvedPoint(scenario, value, {finder, solver}, stop);
}

}  // namespace drillwave
