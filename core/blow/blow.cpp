// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/blow.h"

#include <algorithm>
#include <chrono>

#include "core/blow/impact_summary.h"
#include "core/blow/method.h"
#include "core/blow/outputs.h"
#include "core/blow/result_alerts.h"
#include "core/model/blow_traits.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

void append(std::vector<Alert>& alerts, const std::vector<Alert>& more) {
    alerts.insert(alerts.end(), more.begin(), more.end());
}

void solveTimed(Blow& blow, Detail detail, const std::stop_token& stop, MethodSolver& solver) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    blow.impact = solver.solve(blow.problem, detail, blow.method, stop);
    blow.runTime = std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns whether all numbers are finite; otherwise replaces the result by the reason.
bool holdsNumbers(Blow& blow, Detail detail) {
    Message problem = overflowProblem({blow.summary, blow.scenario}, blow.scales, detail);
    if (problem.isEmpty()) return true;
    blow.impact.outcome = Outcome::notSolved;
    blow.impact.reason = std::move(problem);
    blow.impact.hindrance = Hindrance::other;
    return false;
}

/// Derives feed, forces and alerts from the solution, whose numbers are in the summary.
void conclude(Blow& blow, Detail detail) {
    if (!holdsNumbers(blow, detail)) return;
    blow.feed =
        feedEstimate(blow.scenario, {blow.summary.cor, blow.summary.corError}, blow.summary.transferred);
    const std::optional<RodForces>& ofRod = blow.summary.rodForces;
    append(blow.alerts, resultAlerts(blow.scenario, blow.summary));
    append(blow.alerts, stressAlerts(blow.scenario, ofRod ? sectionStresses(blow.scenario, *ofRod)
                                                          : sectionStresses(blow.scenario, blow.impact)));
    append(blow.alerts, stringAlerts(blow.scenario, blow.impact));
}

/// A drill string, with the forces in every section.
void solveStringBlow(Blow& blow, Detail detail, NetworkAccuracy accuracy, const std::stop_token& stop,
                     MethodSolver& solver) {
    NetworkSettings settings;
    settings.accuracy = accuracy;
    settings.wants.events = true;
    settings.wants.forces = settings.wants.reflections = true;
    settings.wants.histories = detail == Detail::histories;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    ChainSolution solution = solver.solveString(blow.scenario, settings, stop);
    blow.problem = std::move(solution.problem);
    blow.impact = std::move(solution.impact);
    blow.runTime = std::chrono::duration<double>(Clock::now() - start).count();
    if (!blow.isSolved()) return;
    blow.summary = summarize(blow.impact, blow.problem);
    addStresses(blow.summary, blow.scenario, blow.impact, blow.problem.pieces);
    conclude(blow, Detail::histories);
}

void concludeInPassing(Blow& blow, Detail detail, const std::stop_token& stop) {
    blow.summary = summarizeInPassing(blow.impact, blow.problem, {}, stop);
    if (!stop.stop_requested()) return conclude(blow, detail);
    blow.impact.outcome = Outcome::notSolved;
    blow.impact.reason = "stopped";
}

}  // namespace

Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop, Stresses stresses) {
    MethodSolver solver;
    return solveBlow(scenario, method, detail, stop, stresses, solver);
}

Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop, Stresses stresses, MethodSolver& solver,
               NetworkAccuracy ofString) {
    Blow blow;
    blow.scenario = scenario;
    blow.method = method;
    blow.impact.reason = invalidity(scenario);
    if (!blow.impact.reason.isEmpty()) return blow;
    blow.groups = groupsOf(scenario);
    blow.scales = scalesOf(scenario);
    blow.alerts = alertsFor(scenario);
    blow.problem = problemOf(scenario);
    if (blow.isOfString()) {
        solveStringBlow(blow, detail, ofString, stop, solver);
        return blow;
    }
    const bool wantsForces = stresses == Stresses::wanted || hasStrength(scenario.rod);
    const bool mayPass = wantsForces && detail < Detail::histories && method.method == Method::exact;
    const auto solve = [&](Detail wanted) -> const Impact& {
        solveTimed(blow, wanted, stop, solver);
        return blow.impact;
    };
    if (mayPass) {
        const bool tooLong = isTooLongToKeep(solve);
        if (!blow.isSolved()) return blow;
        if (tooLong) {
            concludeInPassing(blow, detail, stop);
            return blow;
        }
    }
    solve(wantsForces ? Detail::histories : detail);
    if (blow.impact.hindrance == Hindrance::histories && detail != Detail::histories) solve(detail);
    if (!blow.isSolved()) return blow;
    blow.summary = summarizeWithWaves(blow.impact, blow.problem);
    conclude(blow, detail);
    return blow;
}

std::string_view methodKey(const Scenario& scenario, Method method) {
    return isFollowedByEvents(scenario) ? name(method) : methodOfStrings;
}

SolverWords solverWords(const Blow& blow) {
    const std::string key(methodKey(blow.scenario, blow.method.method));
    const std::string count = std::to_string(blow.impact.pieces);
    if (key == methodOfStrings) {
        const Message cells = translatable("polynomial cells");
        return {key, cells, cells, "method " + key, {translatable("%1 cells"), {count}}};
    }
    const MethodChoice& choice = blow.method;
    const std::string remark = describe(choice);
    const Message word = nameMessage(choice.method), asked = methodMessage(choice);
    if (choice.method != Method::lattice)
        return {key, word, asked, remark, {translatable("%1 pieces"), {count}}};
    return {key,
            {translatable("%1 of %2 segments"), {word, std::to_string(choice.lattice.segments)}},
            asked,
            remark,
            {translatable("%1 steps"), {count}}};
}

}  // namespace drillwave
