// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/preset.h"

#include <algorithm>
#include <cassert>

#include "core/model/law_change.h"

namespace drillwave {
namespace {

/// The rock with the loading curve of the preset, but for its numbers.
BitRock withCurve(const BitRock& rock, const Preset& preset) {
    BitRock changed = withLaw(rock, preset.law);
    changed.corners = preset.corners;
    return changed;
}

/// "corners, from 90 kN on slope 0.35, from 150 kN on slope 0.7".
std::string curveText(const Preset& preset) {
    std::string text(name(preset.law));
    const Unit& kilonewton = *findUnit(Quantity::force, "kN");
    for (const RockCorner& corner : preset.corners)
        text += ", from " + formatQuantity(corner.force, Quantity::force, kilonewton) + " on slope " +
                formatNumber(corner.slope);
    return text;
}

}  // namespace

Scenario withPreset(Scenario scenario, const Preset& preset) {
    assert(preset.kind == PresetKind::rock ? hasUnits(scenario) : scenario.form == ScenarioForm::dimensional);
    if (preset.shape) {
        scenario.pulse.shape = *preset.shape;
        scenario.pulse.piston.youngsModulus.reset();
        scenario.pulse.piston.density.reset();
    }
    if (preset.kind == PresetKind::rock) scenario.bitRock = withCurve(scenario.bitRock, preset);
    for (const PresetValue& value : preset.values) value.parameter->assign(scenario, value.si);
    return scenario;
}

bool matches(const Preset& preset, const Scenario& scenario) {
    if (preset.kind == PresetKind::rock ? !hasUnits(scenario) : scenario.form != ScenarioForm::dimensional)
        return false;
    if (preset.shape && scenario.pulse.shape != *preset.shape) return false;
    if (preset.kind == PresetKind::rock && withCurve(scenario.bitRock, preset) != scenario.bitRock)
        return false;
    const auto isThere = [&](const PresetValue& value) {
        return isGiven(*value.parameter, scenario) && value.parameter->value(scenario) == value.si;
    };
    const auto names = [&](std::string_view key) {
        return std::ranges::any_of(preset.values,
                                   [&](const PresetValue& v) { return v.parameter->key == key; });
    };
    const Piston& piston = scenario.pulse.piston;
    const bool keepsMaterial = !preset.shape || ((!piston.youngsModulus || names("pulse.youngs_modulus")) &&
                                                 (!piston.density || names("pulse.density")));
    return keepsMaterial && std::ranges::all_of(preset.values, isThere);
}

std::string description(const Preset& preset) {
    std::string text;
    if (preset.shape) text = "shape: " + std::string(name(*preset.shape)) + " — " + preset.shapeSource;
    if (!preset.lawSource.empty()) text = "law: " + curveText(preset) + " — " + preset.lawSource;
    for (const PresetValue& value : preset.values) {
        const Parameter& parameter = *value.parameter;
        if (!text.empty()) text += '\n';
        text += std::string(parameter.label) + ": " +
                formatQuantity(value.si, parameter.quantity, parameter.displayUnit()) + " — " + value.source;
    }
    return text;
}

}  // namespace drillwave
