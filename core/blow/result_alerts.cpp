// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/result_alerts.h"

#include <cmath>
#include <optional>

#include "core/blow/feed_verdict.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"
#include "core/wave/closed/closed_form.h"
#include "core/wave/exact/input_move.h"

namespace drillwave {

namespace {

/// The largest error of e that an engineer need not be told about: what the solver promises in its whole
/// domain.
constexpr double promisedError = 1e-9;

std::string fourDigits(double value) {
    return rounded(value, 4);
}

void addThrust(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    const std::optional<FeedVerdict> verdict = judgeFeed(scenario, summary.cor);
    if (!verdict || (verdict->feed != Feed::pushedBack && verdict->feed != Feed::penetrationLost)) return;
    alerts.push_back({AlertLevel::warning, "thrust_below_needed", "drill.thrust", feedSentence(*verdict)});
}

void addRebound(const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (summary.cor > 1 + summary.corError)
        alerts.push_back(
            {AlertLevel::information, "super_rebound", "",
             "The rod leaves with more momentum than it came with (e = " + fourDigits(summary.cor) +
                 "): rigid rock, e = 1, would underestimate the thrust."});
    if (summary.contacts > 1)
        alerts.push_back({AlertLevel::information, "several_contacts", "",
                          "The bit hits the rock " + std::to_string(summary.contacts) +
                              " times in this blow: the waves in the rod bring it back."});
}

/// Why the closed form is not for a rectangular blow on elastic rock, and the group that is to blame.
struct Obstacle {
    std::string reason;
    std::string parameter;
};

std::optional<Obstacle> closedFormObstacle(const Problem& problem) {
    if (problem.transitTime < 0.5)
        return Obstacle{"the blow is longer than a round trip in the rod (tau = " +
                            fourDigits(problem.transitTime) + " < 0.5)",
                        "tau"};
    if (!closedFormRefusal(problem).empty())
        return Obstacle{"the bit meets the rock in the middle of a wave (delta = " + fourDigits(problem.gap) +
                            " is not a whole number)",
                        "delta"};
    if (overlapIsSmall(problem.law.beta, problem.transitTime)) return std::nullopt;
    return Obstacle{"the bit is still on the rock when the next reflection arrives", "beta"};
}

void addClosedForm(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::rectangular) return;
    const Problem problem = problemOf(scenario);
    if (problem.law.gamma != 1) return;
    const std::optional<Obstacle> obstacle = closedFormObstacle(problem);
    if (!obstacle) return;
    const double closed = closedFormRestitution(problem.law.beta);
    alerts.push_back({AlertLevel::information, "closed_form_invalid", obstacle->parameter,
                      "The closed form for elastic rock does not hold, because " + obstacle->reason +
                          ": its e = " + fourDigits(closed) + " is off by " +
                          fourDigits(std::abs(closed - summary.cor)) + "."});
}

void addAccuracy(const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (summary.corError <= promisedError) return;
    if (summary.growth > coveredGrowth) {
        alerts.push_back(
            {AlertLevel::warning, "input_decides", "",
             "The bit chatters on the rock (" + std::to_string(summary.contacts) +
                 " contacts), so that e depends on the last digits of the input: it is known to " +
                 boundText(summary.corError) +
                 " only, and no calculation knows it better. A longer rod, a shorter blow or a softer rock "
                 "chatters less."});
        return;
    }
    alerts.push_back({AlertLevel::warning, "reduced_accuracy", "",
                      "The numerical error of e may be as large as " + boundText(summary.corError) + "."});
}

}  // namespace

std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary) {
    std::vector<Alert> alerts;
    addThrust(scenario, summary, alerts);
    addRebound(summary, alerts);
    addClosedForm(scenario, summary, alerts);
    addAccuracy(summary, alerts);
    return alerts;
}

namespace {

/// One of the four largest forces in the rod, and when it is there.
struct Load {
    const RodForce& force;
    const char* kind;  ///< "compression"
    bool isAfter;      ///< of the waves left
};

/// The stress of a load against a strength: a warning while the blow lasts; of the waves left, which a real
/// rod damps, a remark.
std::optional<Alert> overload(const Scenario& scenario, const Load& load, double limit,
                              const std::string& code, const std::string& parameter,
                              const std::string& consequence) {
    const double stress = load.force.size * scalesOf(scenario).stress;
    if (stress <= limit) return std::nullopt;
    const std::string text =
        consequence + ": " + load.kind + " reaches " + inHandyUnit(stress, Quantity::stress, 4) + ", " +
        inHandyUnit(load.force.section * scenario.rod.length, Quantity::length, 4) + " from the hammer at " +
        inHandyUnit(load.force.time * scalesOf(scenario).time, Quantity::time, 4) +
        (load.isAfter ? ", after the blow, in the waves left (which nothing damps here)"
                      : ", during the blow") +
        ", against a strength of " + inHandyUnit(limit, Quantity::stress, 4) + ".";
    return Alert{load.isAfter ? AlertLevel::information : AlertLevel::warning, code, parameter, text};
}

/// The larger of compression and tension.
Load largest(const RodForce& compression, const RodForce& tension, bool isAfter) {
    if (compression.size >= tension.size) return {compression, "compression", isAfter};
    return {tension, "tension", isAfter};
}

/// During the blow, or else afterwards: one remark for each strength.
void addOverload(const Scenario& scenario, const Load& during, const Load& after,
                 const std::optional<double>& limit, const std::string& key, const std::string& consequence,
                 std::vector<Alert>& alerts) {
    if (!limit) return;
    const std::string code = "stress_above_" + key.substr(0, key.find('_'));
    for (const Load& load : {during, after})
        if (const auto alert = overload(scenario, load, *limit, code, "rod." + key, consequence))
            return alerts.push_back(*alert);
}

}  // namespace

bool hasStrength(const Rod& rod) {
    return rod.yieldStrength || rod.fatigueStrength;
}

std::vector<Alert> stressAlerts(const Scenario& scenario, const RodForces& forces) {
    if (scenario.form != ScenarioForm::dimensional) return {};
    std::vector<Alert> alerts;
    addOverload(scenario, largest(forces.compression, forces.tension, false),
                largest(forces.compressionAfter, forces.tensionAfter, true), scenario.rod.yieldStrength,
                "yield_strength", "The rod would yield", alerts);
    addOverload(scenario, {forces.tension, "tension", false}, {forces.tensionAfter, "tension", true},
                scenario.rod.fatigueStrength, "fatigue_strength", "The rod tires with every blow", alerts);
    return alerts;
}

}  // namespace drillwave
