// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/preset.h"

#include <algorithm>
#include <cassert>

namespace drillwave {

Scenario withPreset(Scenario scenario, const Preset& preset) {
    assert(preset.kind == PresetKind::rock ? hasUnits(scenario) : scenario.form == ScenarioForm::dimensional);
    if (preset.shape) {
        scenario.pulse.shape = *preset.shape;
        scenario.pulse.piston.youngsModulus.reset();
        scenario.pulse.piston.density.reset();
    }
    for (const PresetValue& value : preset.values) value.parameter->assign(scenario, value.si);
    return scenario;
}

bool matches(const Preset& preset, const Scenario& scenario) {
    if (preset.kind == PresetKind::rock ? !hasUnits(scenario) : scenario.form != ScenarioForm::dimensional)
        return false;
    if (preset.shape && scenario.pulse.shape != *preset.shape) return false;
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
    for (const PresetValue& value : preset.values) {
        const Parameter& parameter = *value.parameter;
        if (!text.empty()) text += '\n';
        text += std::string(parameter.label) + ": " +
                formatQuantity(value.si, parameter.quantity, parameter.displayUnit()) + " — " + value.source;
    }
    return text;
}

}  // namespace drillwave
