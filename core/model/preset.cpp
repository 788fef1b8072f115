// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/preset.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/section_field.h"
#include "core/model/section_pieces.h"
#include "core/model/string_edit.h"
#include "core/text/decimal_text.h"
#include "core/text/enum_names.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

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

constexpr EnumNames<PresetPart> partNames{{{PresetPart::hammer, "hammer"},
                                           {PresetPart::rod, "rod"},
                                           {PresetPart::bit, "bit"},
                                           {PresetPart::rock, "rock"}}};

/// How many sections at the end of the string are the bit: those that are called so.
std::size_t bitSections(const DrillString& drillString) {
    std::size_t count = 0;
    for (auto part = drillString.parts.rbegin(); part != drillString.parts.rend() && !part->group; ++part) {
        if (!part->sections.front().name.starts_with("bit")) break;
        ++count;
    }
    return count;
}

void replaceBit(DrillString& drillString, const SectionPreset& bit) {
    drillString.parts.resize(drillString.parts.size() - bitSections(drillString));
    insertAt(drillString, StringEnd::bit, bit.sections);
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

std::string_view name(SectionPresetKind kind) {
    static constexpr EnumNames<SectionPresetKind> names{{{SectionPresetKind::piston, "piston"},
                                                         {SectionPresetKind::adapter, "adapter"},
                                                         {SectionPresetKind::coupling, "coupling"},
                                                         {SectionPresetKind::bit, "bit"}}};
    return names[kind];
}

namespace {

/// "yield strength 900 MPa, fatigue strength 250 MPa — assumed" of the first section, which stands for all.
std::string strengthText(const SectionPreset& preset, const ReadingStyle& style) {
    std::string text;
    for (const char* key : {"yield_strength", "fatigue_strength"}) {
        const SectionField& field = *findSectionField(key);
        const std::optional<double> value = field.value(preset.sections.front());
        if (!value) continue;
        text += (text.empty() ? "" : ", ") + style.said(Message::ofTable(field.label)) + " " +
                style.quantity(*value, field.quantity);
    }
    return text + " — " + style.said(Message::ofTable(preset.strengthSource));
}

}  // namespace

std::string description(const SectionPreset& preset, const ReadingStyle& style) {
    std::string text;
    for (const Section& section : preset.sections)
        text += (text.empty() ? "" : ", ") + style.withDecimalSign(sizeText(section));
    if (preset.velocity) text += ", " + style.quantity(*preset.velocity, Quantity::velocity);
    text += " — " + style.said(Message::ofTable(preset.source));
    if (!preset.strengthSource.empty()) text += "\n" + strengthText(preset, style);
    return text;
}

Hammer withPiston(Hammer hammer, const SectionPreset& piston) {
    assert(piston.kind == SectionPresetKind::piston);
    hammer.sections = piston.sections;
    if (piston.velocity) hammer.velocity = *piston.velocity;
    return hammer;
}

std::string_view name(PresetPart part) {
    return partNames[part];
}

std::optional<PresetPart> findPresetPart(std::string_view name) {
    for (const PresetPart part : allValues<PresetPart>)
        if (partNames[part] == name) return part;
    return std::nullopt;
}

const std::string& nameOf(const PartPreset& preset) {
    return std::visit([](const auto& each) -> const std::string& { return each.name; }, preset);
}

Message partProblem(PresetPart part, const Scenario& scenario) {
    if (!hasUnits(scenario))
        return translatable(
            "presets need physical units, and this scenario is given by its dimensionless "
            "groups; choose a group such as beta");
    if (part == PresetPart::rock) return {};
    const bool ofString = isString(scenario);
    if (part == PresetPart::bit) {
        if (!ofString) return translatable("a uniform rod has no bit; use a drill string");
        if (bitSections(scenario.drillString) == 0)
            return translatable(
                "the string does not end with a section called bit; name its last section so");
        return {};
    }
    if (!ofString) return {};
    if (part == PresetPart::rod)
        return translatable(
            "a preset of a rod is for uniform rods, and this scenario is a drill string; "
            "choose sizes such as string.rod.diameter");
    if (isForced(scenario))
        return translatable(
            "this drill string is struck by a prescribed force, which no preset replaces; "
            "choose numbers such as pulse.duration");
    return {};
}

bool suits(const PartPreset& preset, PresetPart part, const Scenario& scenario) {
    const bool isForce = part == PresetPart::hammer && isForced(scenario);
    const bool isPiston = part == PresetPart::hammer && !isForced(scenario);
    if (const auto* sections = std::get_if<SectionPreset>(&preset))
        return (part == PresetPart::bit && sections->kind == SectionPresetKind::bit) ||
               (isPiston && sections->kind == SectionPresetKind::piston);
    const PresetKind kind = std::get<Preset>(preset).kind;
    return (isForce && kind == PresetKind::hammer) || (part == PresetPart::rod && kind == PresetKind::rod) ||
           (part == PresetPart::rock && kind == PresetKind::rock);
}

Message replacePart(Scenario& scenario, PresetPart part, const PartPreset& preset) {
    if (Message problem = partProblem(part, scenario); !problem.isEmpty()) return problem;
    assert(suits(preset, part, scenario));
    if (const auto* whole = std::get_if<Preset>(&preset)) {
        scenario = withPreset(std::move(scenario), *whole);
    } else {
        const auto& sections = std::get<SectionPreset>(preset);
        DrillString& drillString = scenario.drillString;
        if (part == PresetPart::hammer)
            drillString.hammer = withPiston(std::move(drillString.hammer), sections);
        else
            replaceBit(drillString, sections);
    }
    return {};
}

PresetChoice::PresetChoice(PresetPart part, std::vector<PartPreset> presets)
    : m_part(part), m_presets(std::move(presets)) {
    assert(!m_presets.empty());
    for (const PartPreset& preset : m_presets) m_words.push_back(nameOf(preset));
}

std::vector<std::string_view> PresetChoice::keys() const {
    std::vector<std::string_view> keys;
    const auto add = [&](std::string_view key) {
        if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    };
    for (const PartPreset& each : m_presets) {
        if (const auto* sections = std::get_if<SectionPreset>(&each)) {
            if (sections->velocity) add("hammer.velocity");
            continue;
        }
        const Preset& preset = std::get<Preset>(each);
        if (preset.shape) add(pulseShapeKey);
        for (const PresetValue& value : preset.values) add(value.parameter->key);
    }
    return keys;
}

bool operator==(const SharedPresetChoice& one, const SharedPresetChoice& other) {
    if (one.m_choice == other.m_choice) return true;
    return one && other && one->part() == other->part() && one->presets() == other->presets();
}

FoundName findPresetName(std::span<const std::string_view> names, std::string_view wanted,
                         const std::string& list) {
    const std::string low = lowerCase(std::string(wanted));
    std::vector<std::string_view> near;
    std::vector<std::size_t> beginning;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (lowerCase(std::string(names[i])) == low) return {i, {}};
        near.push_back(names[i]);
        near.push_back(names[i].substr(0, names[i].find(',')));  // is enough, too
        if (!low.empty() && lowerCase(std::string(names[i])).starts_with(low)) beginning.push_back(i);
    }
    if (beginning.size() == 1) return {beginning.front(), {}};
    if (!beginning.empty()) {
        std::string candidates;
        for (const std::size_t i : beginning)
            candidates += (candidates.empty() ? "`" : ", `") + std::string(names[i]) + "`";
        return {0, {translatable("may be %1; give the whole name"), {candidates}}};
    }
    if (const std::string meant(nearestName(wanted, near)); !meant.empty())
        return {0, {translatable("is not known; did you mean `%1`?"), {meant}}};
    return {0, {translatable("is not known; `%1` lists them"), {list}}};
}

}  // namespace drillwave
