// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/alerts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/model/drill_string.h"
#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/model/section_field.h"
#include "core/model/section_words.h"
#include "core/text/enum_names.h"

namespace drillwave {
namespace {

/// Largest share of the impulse after the return of the first reflection that needs no alert.
constexpr double negligibleImpulse = 1e-3;

/// Relative difference up to which hammer and rod have equal impedances.
constexpr double matchedImpedances = 0.01;

void addImplausibleValue(const Parameter& parameter, const Scenario& scenario, std::vector<Alert>& alerts) {
    const std::optional<double> value = parameter.value(scenario);
    if (!value || parameter.plausible.contains(*value)) return;
    alerts.push_back({AlertLevel::warning,
                      AlertCode::implausibleValue,
                      std::string(parameter.key),
                      {{"value", *value, parameter.quantity}}});
}

void addImplausibleValues(const Scenario& scenario, std::vector<Alert>& alerts) {
    for (const Parameter& parameter : parameters())
        if (parameter.scope != Scope::manyBlows && isGiven(parameter, scenario))
            addImplausibleValue(parameter, scenario, alerts);
    for (const KeptParameter& parameter : loadingNumbers(scenario))
        addImplausibleValue(*parameter, scenario, alerts);
}

/// The largest force of a tabulated blow, which a wrong unit makes a thousand times what it is.
void addImplausiblePeak(const Scenario& scenario, std::vector<Alert>& alerts) {
    const TablePoints& points = scenario.pulse.tablePoints;
    if (scenario.pulse.shape != PulseShape::table || !hasUnits(scenario) || points.empty()) return;
    const double peak = std::ranges::max_element(points, {}, &TablePoint::force)->force;
    const Parameter& force = *findParameter("pulse.force");
    if (force.plausible.contains(peak)) return;
    alerts.push_back({AlertLevel::warning,
                      AlertCode::implausibleValue,
                      "pulse.force",
                      {{"value", peak, Quantity::force}},
                      translatable("largest force of the table")});
}

void addImplausibleSection(SectionAddress::Chain chain, std::uint64_t place, const Section& section,
                           const DrillString& drillString, std::vector<Alert>& alerts) {
    for (const SectionField& field : sectionFields()) {
        const std::optional<double> value = field.value(section);
        if (!value || field.plausible.contains(*value)) continue;
        alerts.push_back({AlertLevel::warning,
                          AlertCode::implausibleValue,
                          sectionKey(chain, place, field.key),
                          {{"value", *value, field.quantity}},
                          addressedWords({chain, {}, place, &field}, drillString)});
    }
}

/// Adds the sections of a string, each as often as it stands in a file.
void addImplausibleSections(const DrillString& drillString, std::vector<Alert>& alerts) {
    using Chain = SectionAddress::Chain;
    for (std::size_t i = 0; i < drillString.hammer.sections.size(); ++i)
        addImplausibleSection(Chain::hammer, i + 1, drillString.hammer.sections[i], drillString, alerts);
    for (const PlacedSection& placed : placedSections(drillString))
        addImplausibleSection(Chain::string, placed.place, *placed.section, drillString, alerts);
}

void addLongPulse(const Scenario& scenario, std::vector<Alert>& alerts) {
    const PulseForce force = pulseForceOf(scenario);
    if (force.isRigidBody()) return;
    const double late = 1 - force.impulseUntil(2 * groupsOf(scenario).tau);
    if (late <= negligibleImpulse) return;
    alerts.push_back({AlertLevel::warning, AlertCode::longPulse, "tau", {{"late_impulse", late}}});
}

/// A shape chosen without the data of a hammer gets a hammer all the same: that must not go unsaid.
void addDefaultHammer(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::piston || scenario.pulse.piston != Piston()) return;
    if (scenario.form == ScenarioForm::dimensionless) {
        alerts.push_back({AlertLevel::information, AlertCode::defaultHammer, "pulse.impedance_ratio", {}});
        return;
    }
    Alert alert{AlertLevel::information, AlertCode::defaultHammer, "pulse.length", {}};
    for (const std::string_view key : {"pulse.length", "pulse.diameter", "pulse.velocity"}) {
        const Parameter& parameter = *findParameter(key);
        alert.arguments.push_back({key, *parameter.value(scenario), parameter.quantity});
    }
    alerts.push_back(alert);
}

void addPistonAssumption(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::piston) return;
    const double ratio = pistonImpedanceRatio(scenario);
    if (std::abs(ratio - 1) < matchedImpedances) return;
    alerts.push_back({AlertLevel::information,
                      AlertCode::pistonImpedance,
                      hasUnits(scenario) ? "pulse.diameter" : "pulse.impedance_ratio",
                      {{"ratio", ratio}}});
}

void addGapWithoutEffect(const Scenario& scenario, std::vector<Alert>& alerts) {
    if (scenario.pulse.shape != PulseShape::rigidBody || groupsOf(scenario).delta == 0) return;
    alerts.push_back({AlertLevel::information,
                      AlertCode::gapWithoutEffect,
                      hasUnits(scenario) ? "bit_rock.gap" : "delta",
                      {}});
}

bool hasLosses(const DrillString& drillString) {
    return std::ranges::any_of(expandedSections(drillString), [](const Section* section) {
        return section->loss > 0 || section->attenuation > 0;
    });
}

void addResidualWaves(const Scenario& scenario, std::vector<Alert>& alerts) {
    const std::optional<double> roundTrips = roundTripsBetweenBlows(scenario);
    if (!roundTrips || *roundTrips >= enoughRoundTrips) return;
    Alert alert{AlertLevel::information,
                AlertCode::residualWaves,
                "drill.blow_frequency",
                {{"round_trips", *roundTrips}}};
    if (scenario.drill.waveLoss.value_or(0) > 0)
        alert.arguments.push_back({"wave_loss", *scenario.drill.waveLoss});
    else if (hasLosses(scenario.drillString))
        alert.arguments.push_back({"losses_of_string", 1});
    if (const std::optional<int> whole = stepOfWaves(*roundTrips)) {
        alert.level = AlertLevel::warning;
        alert.arguments.push_back({"whole", static_cast<double>(*whole)});
    }
    alerts.push_back(alert);
}

}  // namespace

std::string_view name(AlertCode code) {
    using enum AlertCode;
    static constexpr EnumNames<AlertCode> alertNames{{{implausibleValue, "outside_plausible_range"},
                                                      {longPulse, "pulse_longer_than_round_trip"},
                                                      {defaultHammer, "default_hammer"},
                                                      {pistonImpedance, "piston_impedance_ratio"},
                                                      {gapWithoutEffect, "gap_without_effect"},
                                                      {thrustBelowNeeded, "thrust_below_needed"},
                                                      {superRebound, "super_rebound"},
                                                      {severalContacts, "several_contacts"},
                                                      {closedFormInvalid, "closed_form_invalid"},
                                                      {inputDecides, "input_decides"},
                                                      {reducedAccuracy, "reduced_accuracy"},
                                                      {stressAboveYield, "stress_above_yield"},
                                                      {stressAboveFatigue, "stress_above_fatigue"},
                                                      {residualWaves, "residual_waves"},
                                                      {lengthsRounded, "lengths_rounded"},
                                                      {wavesThinned, "waves_thinned"},
                                                      {blowNotOver, "blow_not_over"},
                                                      {stressesLeftOut, "stresses_left_out"},
                                                      {cornersWithoutEffect, "corners_without_effect"},
                                                      {pushedBack, "pushed_back"},
                                                      {noWaveLoss, "no_wave_loss"},
                                                      {restrikeInTheWay, "restrike_in_the_way"},
                                                      {shankOff, "shank_off"},
                                                      {frequencyRounded, "frequency_rounded"},
                                                      {notSettled, "not_settled"},
                                                      {coexistingMotions, "coexisting_motions"},
                                                      {irregularMotion, "irregular_motion"},
                                                      {energyUnbalanced, "energy_unbalanced"},
                                                      {damperAssumed, "damper_assumed"}}};
    return alertNames[code];
}

bool Alert::has(std::string_view argument) const {
    return std::ranges::find(arguments, argument, &AlertArgument::name) != arguments.end();
}

const AlertArgument& Alert::argument(std::string_view name) const {
    const auto found = std::ranges::find(arguments, name, &AlertArgument::name);
    assert(found != arguments.end());
    return *found;
}

std::vector<Alert> alertsFor(const Scenario& scenario) {
    std::vector<Alert> alerts;
    addImplausibleValues(scenario, alerts);
    addImplausibleSections(scenario.drillString, alerts);
    if (isForced(scenario)) {
        addImplausiblePeak(scenario, alerts);
        addLongPulse(scenario, alerts);
        addDefaultHammer(scenario, alerts);
        addPistonAssumption(scenario, alerts);
        addGapWithoutEffect(scenario, alerts);
    }
    addResidualWaves(scenario, alerts);
    return alerts;
}

}  // namespace drillwave
