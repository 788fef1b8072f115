// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/parameter_facts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/report/parameter_words.h"
#include "core/text/handy_text.h"
#include "core/yaml/preset_file.h"

namespace drillwave {
namespace {

// More different values than these are told by their ends.
constexpr std::size_t mostPresetValues = 5;

std::string withUnit(const std::string& number, const Unit& unit) {
    return unit.name.empty() ? number : number + " " + std::string(unit.name);
}

std::string usualText(const Range& range, const Unit& unit, const ReadingStyle& style) {
    return style.number(unit.fromSi(range.low)) + " – " +
           withUnit(style.number(unit.fromSi(range.high)), unit);
}

// "(0, 1]"; where a decimal comma stands in it, "(0; 0,5]".
std::string endsText(const Range& range, const ReadingStyle& style) {
    std::string ends = style.withDecimalSign(range.ends());
    if (ends != range.ends()) ends.replace(ends.find(", "), 1, ";");
    return ends;
}

Message rangeMessage(const Range& range, const ReadingStyle& style) {
    if (std::isfinite(range.high)) return {translatable("in %1"), {endsText(range, style)}};
    return {range.lowOpen ? translatable("greater than %1") : translatable("at least %1"),
            {style.withDecimalSign(formatNumber(range.low))}};
}

Message hardMessage(const Range& range, Quantity quantity, const ReadingStyle& style) {
    const Unit& si = unitsOf(quantity).front();
    if (!std::isfinite(range.high) || si.name.empty()) return rangeMessage(range, style);
    if (quantity == Quantity::angle) return {"%1 %2", {rangeMessage(range, style), std::string(si.name)}};
    const std::string high = style.quantity(range.high, quantity);
    if (range.lowOpen) return {translatable("greater than 0, at most %1"), {high}};
    return style.quantity(range.low, quantity) + " – " + high;
}

Message presenceMessage(Presence presence, std::string_view rival) {
    switch (presence) {
        case Presence::required:
            return translatable("required");
        case Presence::either:
            if (rival.empty()) return translatable("required, or what stands in its place");
            return {translatable("required, or `%1`"), {std::string(rival)}};
        case Presence::assumed:
        case Presence::unusual:
            return translatable("may be left out: the program then assumes a value");
        case Presence::optional:
            return translatable("may be left out");
    }
    return {};
}

Message conditionMessage(Scope scope) {
    switch (scope) {
        case Scope::all:
        case Scope::section:
            return {};
        case Scope::withUnits:
            return translatable("scenarios in physical units");
        case Scope::withoutUnits:
            return translatable("dimensionless scenarios");
        case Scope::manyBlows:
            return translatable(
                "scenarios in physical units, for many blows: one alone does not depend on it");
        case Scope::string:
            return translatable("drill strings");
        case Scope::hammer:
            return translatable("drill strings that a hammer strikes");
        case Scope::uniformRod:
            return translatable("uniform rods, with units and without");
        case Scope::dimensional:
            return translatable("uniform rods in physical units");
        case Scope::withoutArea:
            return translatable("uniform rods in physical units, given by their diameter");
        case Scope::givenPulse:
            return translatable("hammer forces in physical units, but those of a piston or a table");
        case Scope::trapezoid:
            return translatable("hammer forces of the shape `trapezoid`");
        case Scope::pistonInSi:
            return translatable("hammer forces of the shape `piston`, in physical units");
        case Scope::pistonByRatio:
            return translatable("hammer forces of the shape `piston`, dimensionless");
    }
    return {};
}

template <class Row>
ParameterFacts commonFacts(const Row& row, const Message& label, const ReadingStyle& style) {
    std::string title = style.said(label);
    if (!row.symbol.empty()) title += " " + std::string(row.symbol);
    return {.key = std::string(row.key),
            .title = std::move(title),
            .meaning = style.patternFor(std::string(row.meaning)),
            .unit = std::string(row.unit),
            .range = style.said(hardMessage(row.hard, row.quantity, style)),
            .usual = usualText(row.plausible, row.displayUnit(), style),
            .presence = {},
            .condition = {}};
}

}  // namespace

ParameterFacts factsOf(const Parameter& parameter, const ReadingStyle& style) {
    ParameterFacts facts = commonFacts(parameter, labelMessage(parameter), style);
    if (parameter.rules.wholeNumber)
        facts.range = style.said({translatable("a whole number %1"), {facts.range}});
    facts.presence = style.said(presenceMessage(parameter.rules.presence, parameter.rules.rival));
    const std::optional<RockLaw> law = parameter.rules.law;
    facts.condition = style.said(law ? Message(translatable("rock with `law: %1`"), {std::string(name(*law))})
                                     : conditionMessage(parameter.scope));
    return facts;
}

ParameterFacts factsOf(const SectionField& field, const ReadingStyle& style) {
    ParameterFacts facts = commonFacts(field, Message::ofTable(field.label), style);
    facts.presence = style.said(presenceMessage(field.presence, {}));
    return facts;
}

std::vector<std::string> presetValues(const Parameter& parameter, const ReadingStyle& style) {
    std::map<double, std::map<std::string, std::string>> values;  // by source: names of presets
    for (const Preset& preset : builtInPresets())
        for (const PresetValue& value : preset.values)
            if (value.parameter->key == parameter.key) {
                std::string& names = values[value.si][style.patternFor(value.source)];
                names += (names.empty() ? "" : "; ") + nameFor(preset.name, style);
            }
    if (values.empty()) return {};
    const Unit& unit = parameter.displayUnit();
    const auto text = [&](double si) { return withUnit(style.number(unit.fromSi(si)), unit); };
    if (values.size() > mostPresetValues)
        return {style.said({translatable("%1 to %2, of `drillwave presets`"),
                            {text(values.begin()->first), text(values.rbegin()->first)}})};
    std::vector<std::string> lines;
    for (const auto& [si, sources] : values)
        for (const auto& [source, names] : sources)
            lines.push_back(text(si) + ": " + names + " (" + source + ")");
    return lines;
}

}  // namespace drillwave
