// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/preset.h"

#include <cassert>

namespace drillwave {

Scenario withPreset(Scenario scenario, const Preset& preset) {
    assert(scenario.form == ScenarioForm::dimensional);
    if (preset.shape) {
        scenario.pulse.shape = *preset.shape;
        scenario.pulse.piston.youngsModulus.reset();
        scenario.pulse.piston.density.reset();
    }
    for (const PresetValue& value : preset.values) value.parameter->assign(scenario, value.si);
    return scenario;
}

bool matches(const Preset& preset, const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional && withPreset(scenario, preset) == scenario;
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
