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

/// "a law with corners, from 90 kN on slope 0.35, from 150 kN on slope 0.7".
std::string curveText(const Preset& preset, const ReadingStyle& style) {
    std::string text = style.said(Message::ofTable(phrase(preset.law)));
    for (const RockCorner& corner : preset.corners)
        text +=
            ", " + style.said({translatable("from %1 on slope %2"),
                               {style.quantity(corner.force, Quantity::force), style.number(corner.slope)}});
    return text;
}

/// "diameter: 38 mm — nominal".
std::string valueLine(const Message& label, const std::string& value, const std::string& source,
                      const ReadingStyle& style) {
    return style.said(label) + ": " + value + " — " + style.said(Message::ofTable(source));
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

std::string nameFor(const std::string& name, const ReadingStyle& style) {
    const std::string translated = style.patternFor(name);
    return translated == name ? name : name + " — " + translated;
}

std::string description(const Preset& preset, const ReadingStyle& style) {
    std::string text;
    if (preset.shape)
        text = valueLine(translatable("shape"), style.name(name(*preset.shape)), preset.shapeSource, style);
    if (!preset.lawSource.empty())
        text = valueLine(translatable("loading curve"), curveText(preset, style), preset.lawSource, style);
    for (const PresetValue& value : preset.values) {
        const Parameter& parameter = *value.parameter;
        if (!text.empty()) text += '\n';
        text += valueLine(Message::ofTable(parameter.label), style.quantity(value.si, parameter.quantity),
                          value.source, style);
    }
    return text;
}

}  // namespace drillwave
