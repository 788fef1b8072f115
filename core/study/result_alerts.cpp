#include "core/study/result_alerts.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/model/decimal_text.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/study/thrust.h"
#include "core/wave/closed_form.h"

namespace drillwave {

namespace {

/// The largest error of e that an engineer need not be told about: what the solver promises in its whole
/// domain.
constexpr double promisedError = 1e-9;

std::string rounded(double value) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
    return {text.data(), end.ptr};
}

void addThrust(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    const std::optional<double> needed = thrustNeeded(scenario, summary.cor);
    const std::optional<double> installed = scenario.drill.thrust;
    if (!needed || !installed || *installed >= *needed) return;
    alerts.push_back({AlertLevel::warning, "thrust_below_needed", "drill.thrust",
                      "The installed thrust of " + rounded(*installed / 1000) + " kN is below the " +
                          rounded(*needed / 1000) +
                          " kN that these blows need: the bit will leave the rock between blows."});
}

void addRebound(const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (summary.cor > 1 + summary.corError)
        alerts.push_back({AlertLevel::information, "super_rebound", "",
                          "The rod leaves with more momentum than it came with (e = " + rounded(summary.cor) +
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

std::optional<Obstacle> closedFormObstacle(const PulseForce& pulse, const Groups& groups) {
    if (groups.tau < 0.5)
        return Obstacle{
            "the blow is longer than a round trip in the rod (tau = " + rounded(groups.tau) + " < 0.5)",
            "tau"};
    if (!closedFormRefusal(pulse, groups).empty())
        return Obstacle{"the bit meets the rock in the middle of a wave (delta = " + rounded(groups.delta) +
                            " is not a whole number)",
                        "delta"};
    if (overlapIsSmall(groups.beta, groups.tau)) return std::nullopt;
    return Obstacle{"the bit is still on the rock when the next reflection arrives", "beta"};
}

void addClosedForm(const Scenario& scenario, const ImpactSummary& summary, std::vector<Alert>& alerts) {
    const Groups groups = groupsOf(scenario);
    if (scenario.pulse.shape != PulseShape::rectangular || groups.gamma != 1) return;
    const std::optional<Obstacle> obstacle = closedFormObstacle(pulseForceOf(scenario), groups);
    if (!obstacle) return;
    const double closed = closedFormRestitution(groups.beta);
    alerts.push_back({AlertLevel::information, "closed_form_invalid", obstacle->parameter,
                      "The closed form for elastic rock does not hold, because " + obstacle->reason +
                          ": its e = " + rounded(closed) + " is off by " +
                          rounded(std::abs(closed - summary.cor)) + "."});
}

void addAccuracy(const ImpactSummary& summary, std::vector<Alert>& alerts) {
    if (summary.corError <= promisedError) return;
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

std::vector<Alert> stressAlerts(const Scenario& scenario, const RodForces& forces) {
    const std::optional<double> limit = scenario.rod.yieldStrength;
    if (scenario.form != ScenarioForm::dimensional || !limit) return {};
    const bool pushed = forces.compression.size >= forces.tension.size;
    const RodForce& largest = pushed ? forces.compression : forces.tension;
    const double stress = largest.size * scalesOf(scenario).force / propertiesOf(scenario.rod).area;
    if (stress <= *limit) return {};
    return {{AlertLevel::warning, "stress_above_yield", "rod.yield_strength",
             "The rod would yield: its largest stress is " + rounded(stress / 1e6) + " MPa in " +
                 (pushed ? "compression" : "tension") + ", " +
                 rounded(largest.section * scenario.rod.length) +
                 " m from the hammer, against a yield strength of " + rounded(*limit / 1e6) + " MPa."}};
}

}  // namespace drillwave
