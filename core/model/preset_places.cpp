// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/preset_places.h"

#include <algorithm>
#include <optional>

#include "core/model/assignments.h"
#include "core/model/validation.h"

namespace drillwave {
namespace {

/// Presets at one value that are named there.
constexpr int mostNames = 2;

bool sets(const Preset& preset, const Parameter& parameter) {
    return std::ranges::any_of(preset.values, [&](const PresetValue& value) {
        return drillwave::areRivals(value.parameter->key, parameter.key);
    });
}

std::optional<Scenario> taken(const Preset& preset, const Scenario& scenario) {
    // A string takes only rocks.
    const bool isTaken =
        preset.kind == PresetKind::rock ? hasUnits(scenario) : scenario.form == ScenarioForm::dimensional;
    if (!isTaken) return std::nullopt;
    // On another loading curve the same numbers are another rock.
    if (preset.kind == PresetKind::rock && preset.law != scenario.bitRock.law) return std::nullopt;
    const Scenario with = withPreset(scenario, preset);
    if (!validate(with).empty()) return std::nullopt;
    return with;
}

}  // namespace

std::vector<PresetPlace> presetPlaces(std::span<const Preset> presets, const Parameter& parameter,
                                      const Scenario& scenario) {
    std::vector<PresetPlace> places;
    for (const Preset& preset : presets) {
        if (!sets(preset, parameter)) continue;
        const std::optional<Scenario> with = taken(preset, scenario);
        if (!with || !parameter.applies(*with)) continue;
        if (const auto si = parameter.value(*with)) places.push_back({Message::ofTable(preset.name), *si});
    }
    std::ranges::stable_sort(places, {}, &PresetPlace::si);
    std::vector<PresetPlace> together;
    int names = 0;  // of the last one
    for (PresetPlace& place : places) {
        const bool isNew = together.empty() || together.back().si != place.si;
        names = isNew ? 1 : names + 1;
        if (isNew)
            together.push_back(std::move(place));
        else if (names <= mostNames)
            together.back().name = joined(together.back().name, "%1, %2", place.name);
        else if (names == mostNames + 1)
            together.back().name = {"%1, …", {together.back().name}};
    }
    return together;
}

std::vector<PresetPoint> presetPoints(std::span<const Preset> presets, const Parameter& x, const Parameter& y,
                                      const Scenario& scenario) {
    std::vector<PresetPoint> points;
    for (const Preset& preset : presets) {
        if (!sets(preset, x) || !sets(preset, y)) continue;
        const std::optional<Scenario> with = taken(preset, scenario);
        if (!with || !x.applies(*with) || !y.applies(*with)) continue;
        const auto atX = x.value(*with), atY = y.value(*with);
        if (atX && atY) points.push_back({Message::ofTable(preset.name), *atX, *atY});
    }
    return points;
}

}  // namespace drillwave
