// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/alerts.h"

#include <cmath>

#include "core/model/parameter.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/text/handy_text.h"

namespace drillwave {
namespace {

/// What may be pushed after the first reflection has returned before it is worth a remark.
constexpr double negligibleImpulse = 1e-3;

/// Hammer and rod within one percent pass for equal.
constexpr double matchedImpedances = 0.01;

std::string inUnit(const Parameter& parameter, double value) {
    return formatQuantity(value, parameter.quantity, parameter.displayUnit());
}

/// Of a value that may be anything: rounded, in a unit in which it can be read.
std::string brief(const Parameter& parameter, double value) {
    return inHandyUnit(value, parameter.quantity, 4);
}

/// "stiffness k", as in the form: in words, not as in a file.
std::string nameOf(const Parameter& parameter) {
    std::string name(parameter.label);
    if (!parameter.symbol.empty()) name += " " + std::string(parameter.symbol);
    return name;
}

void addImplausibleValues(const Scenario& scenario, std::vector<Alert>& alerts) {
    for (const Parameter& parameter : parameters()) {
        if (!isGiven(parameter, scenario)) continue;
        const std::optional<double> value = parameter.value(scenario);
        if (!value || parameter.plausible.contains(*value)) continue;
        const std::string text = "The " + nameOf(parameter) + " = " + brief(parameter, *value) +
                                 " is outside the usual range, " + brief(parameter, parameter.plausible.low) +
                                 " to " + brief(parameter, parameter.plausible.high) + ".";
        alerts.push_back(
            {AlertLevel::warning, std::string(implausibleValue), std::string(parameter.key), text});
    }
}

void addLongPulse(const Scenario& scenario, std::vector<Alert>& alerts) {
    const PulseForce force = pulseForceOf(scenario);
    if (force.isRigidBody()) return;
    const double late = 1 - force.impulseUntil(2 * groupsOf(scenario).tau);
    if (late <= negligibleImpulse) return;
    const double percent = static_cast<double>(static_cast<int>(late * 1000)) / 10;
    alerts.push_back(
        {AlertLevel::warning, "pulse_longer_than_round_trip", "tau",
         "The first reflection is back while " + formatNumber(percent) +
             " % of the blow is still to come; a real hammer would feel it, here its force is prescribed."});
}

/// A shape chosen without the data of a hammer gets a hammer all the same: that must not go unsaid.
void addDefaultHammer(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::piston || scenario.pulse.piston != Piston()) return;
    if (scenario.form == ScenarioForm::dimensionless) {
        alerts.push_back({AlertLevel::information, "default_hammer", "pulse.impedance_ratio",
                          "The hammer's impedance is that of the rod, the value assumed where none is given: "
                          "its blow is one step."});
        return;
    }
    std::string values;
    for (const std::string_view key : {"pulse.length", "pulse.diameter", "pulse.velocity"}) {
        const Parameter& parameter = *findParameter(key);
        values += (values.empty() ? "" : ", ") + std::string(parameter.localKey()) + " " +
                  inUnit(parameter, *parameter.value(scenario));
    }
    alerts.push_back({AlertLevel::information, "default_hammer", "pulse.length",
                      "The hammer is the one assumed where none is given (" + values +
                          ", the material of the rod): give the data of the rock drill's piston."});
}

void addPistonAssumption(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::piston) return;
    const double ratio = pistonImpedanceRatio(scenario);
    if (std::abs(ratio - 1) < matchedImpedances) return;
    alerts.push_back(
        {AlertLevel::information, "piston_impedance_ratio",
         scenario.form == ScenarioForm::dimensional ? "pulse.diameter" : "pulse.impedance_ratio",
         ratio < 1
             ? "The hammer's impedance is below the rod's: it bounces back after one step, so that the rod "
               "takes "
               "over more than its momentum."
             : "The hammer's impedance is above the rod's: it pushes in a staircase of ever smaller steps, "
               "assumed to run on as if the rod were long."});
}

void addGapWithoutEffect(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::rigidBody || groupsOf(scenario).delta == 0) return;
    alerts.push_back({AlertLevel::information, "gap_without_effect",
                      scenario.form == ScenarioForm::dimensional ? "bit_rock.gap" : "delta",
                      "The gap has no effect on a rigid body motion: it only shifts the time of contact."});
}

}  // namespace

std::vector<Alert> alertsFor(const Scenario& scenario) {
    std::vector<Alert> alerts;
    addImplausibleValues(scenario, alerts);
    addLongPulse(scenario, alerts);
    addDefaultHammer(scenario, alerts);
    addPistonAssumption(scenario, alerts);
    addGapWithoutEffect(scenario, alerts);
    return alerts;
}

}  // namespace drillwave
