// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/solved_blow.h"

#include <chrono>
#include <exception>

#include "core/blow/result_alerts.h"
#include "core/model/alerts.h"

namespace drillwave {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void solve(SolvedBlow& blow, ExactSolver& solver) {
    blow.pulse = pulseForceOf(blow.request.scenario);
    const auto start = std::chrono::steady_clock::now();
    blow.impact = solver.solve(blow.pulse, blow.groups, Detail::histories, blow.request.stop);
    blow.runTime = secondsSince(start);
    if (blow.impact.outcome != Outcome::rebounded) {
        blow.problem = QString::fromStdString(blow.impact.reason);
        if (blow.problem.isEmpty()) blow.problem = QStringLiteral("The blow could not be solved.");
        return;
    }
    blow.summary = summarize(blow.impact, blow.groups);
    blow.feed = judgeFeed(blow.request.scenario, blow.impact.cor);
    blow.rodForces = largestRodForces(blow.impact, blow.pulse);
    for (const std::vector<Alert>& remarks : {resultAlerts(blow.request.scenario, blow.summary),
                                              stressAlerts(blow.request.scenario, blow.rodForces)})
        blow.alerts.insert(blow.alerts.end(), remarks.begin(), remarks.end());
    for (const PreparePage& prepare : blow.request.pages) blow.pages.push_back(prepare(blow));
}

}  // namespace

SolvedBlowPtr solveBlow(const SolveRequest& request, ExactSolver& solver) noexcept {
    auto blow = std::make_shared<SolvedBlow>();
    try {
        blow->request = request;
        const std::vector<Problem> problems = validate(request.scenario);
        if (!problems.empty()) return failedBlow(request, QString::fromStdString(problems.front().text));
        blow->groups = groupsOf(request.scenario);
        blow->scales = scalesOf(request.scenario);
        blow->units = shownUnits(request.units, blow->scales);
        blow->alerts = alertsFor(request.scenario);
        solve(*blow, solver);
    } catch (const std::exception& error) {
        return failedBlow(request, QString::fromUtf8(error.what()));
    }
    return blow;
}

SolvedBlowPtr failedBlow(const SolveRequest& request, const QString& problem) {
    auto blow = std::make_shared<SolvedBlow>();
    blow->request = request;
    blow->problem = problem;
    return blow;
}

}  // namespace drillwave
