// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/result_alerts.h"

#include <cmath>
#include <optional>

#include "core/blow/feed_estimate.h"
#include "core/model/alerts.h"
#include "core/model/blow_traits.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/wave/closed/closed_form.h"
#include "core/wave/exact/input_move.h"

namespace drillwave {

namespace {

/// Largest error of e that needs no alert: what the solver promises in its whole
/// domain.
constexpr double promisedError = 1e-9;

/// Largest error of e that changes no shown digit: half of the fourth decimal. With a larger one the result
/// is doubtful.
constexpr double shownError = 5e-5;

void addThrust(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    const std::optional<FeedEstimate> feed =
        feedEstimate(scenario, {summary.cor, summary.corError}, summary.transferred);
    if (!feed || !feed->isTooLittle()) return;
    Alert alert{AlertLevel::warning,
                AlertCode::thrustBelowNeeded,
                "drill.thrust",
                {{"installed", feed->force->thrust, Quantity::force},
                 {"balance", feed->balance, Quantity::force},
                 {"required", feed->need(ThrustCase::scenario).thrust, Quantity::force},
                 {"frequency", *scenario.drill.blowFrequency, Quantity::frequency}}};
    if (feed->force->weight) alert.arguments.push_back({"weight", *feed->force->weight, Quantity::force});
    alerts.push_back(alert);
}

void addRebound(bool isExact, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (isExact && summary.cor > 1 + summary.corError)
        alerts.push_back({AlertLevel::information, AlertCode::superRebound, "", {{"cor", summary.cor}}});
    if (summary.contacts > 1)
        alerts.push_back({AlertLevel::information,
                          AlertCode::severalContacts,
                          "",
                          {{"contacts", static_cast<double>(summary.contacts)}}});
}

/// The group that is to blame where the closed form is not for a rectangular blow on elastic rock.
std::optional<AlertArgument> closedFormObstacle(const Problem& problem) {
    if (!problem.law.isBilinear())
        return AlertArgument{rockLawKey, static_cast<double>(problem.law.corners.size())};
    if (problem.transitTime() < 0.5) return AlertArgument{"tau", problem.transitTime()};
    if (!closedFormRefusal(problem).isEmpty()) return AlertArgument{"delta", problem.gap};
    if (overlapIsSmall(problem.law.beta, problem.transitTime())) return std::nullopt;
    return AlertArgument{"beta", problem.law.beta};
}

void addClosedForm(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::rectangular) return;
    const Problem problem = problemOf(scenario);
    if (problem.law.gamma != 1) return;
    const std::optional<AlertArgument> obstacle = closedFormObstacle(problem);
    if (!obstacle) return;
    const double closed = closedFormRestitution(problem.law.beta);
    alerts.push_back(
        {AlertLevel::information,
         AlertCode::closedFormInvalid,
         std::string(obstacle->name),
         {*obstacle, {"closed_form_cor", closed}, {"difference", std::abs(closed - summary.cor)}}});
}

/// The forces that the law is about are never met.
void addCornersWithoutEffect(const Scenario& scenario, const ImpactSummary& summary,
                             std::vector<Alert>& alerts) {
    const BitRock& rock = scenario.bitRock;
    if (rock.law != RockLaw::corners || rock.corners.empty()) return;
    const double force = hasUnits(scenario) ? scalesOf(scenario).force : 1;
    const double peak = summary.peakForce * force, first = rock.corners.front().force;
    if (peak >= first) return;
    const Quantity quantity = hasUnits(scenario) ? Quantity::force : Quantity::ratio;
    alerts.push_back({AlertLevel::information,
                      AlertCode::cornersWithoutEffect,
                      "bit_rock.law",
                      {{"peak_force", peak, quantity}, {"corner_force", first, quantity}}});
}

void addAccuracy(const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (summary.corError <= promisedError) return;
    if (summary.growth > coveredGrowth) {
        alerts.push_back(
            {AlertLevel::warning,
             AlertCode::inputDecides,
             "",
             {{"contacts", static_cast<double>(summary.contacts)}, {"cor_error", summary.corError}}});
        return;
    }
    alerts.push_back({summary.corError > shownError ? AlertLevel::warning : AlertLevel::information,
                      AlertCode::reducedAccuracy,
                      "",
                      {{"cor_error", summary.corError}}});
}

}  // namespace

std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary) {
    std::vector<Alert> alerts;
    addThrust(scenario, summary, alerts);
    const bool isExact = isFollowedByEvents(scenario);
    addRebound(isExact, summary, alerts);
    if (isExact) addClosedForm(scenario, summary, alerts);
    addCornersWithoutEffect(scenario, summary, alerts);
    addAccuracy(summary, alerts);
    return alerts;
}

bool hasStrength(const Rod& rod) {
    return rod.yieldStrength || rod.fatigueStrength;
}

}  // namespace drillwave
