// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/parameter_facts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text/handy_text.h"
#include "core/text/number_text.h"
#include "core/yaml/preset_file.h"

namespace drillwave {
namespace {

// More different values than these are told by their ends.
constexpr std::size_t mostPresetValues = 5;

std::string withUnit(const std::string& number, const Unit& unit) {
    return unit.name.empty() ? number : number + " " + std::string(unit.name);
}

std::string usualText(const Range& range, const Unit& unit) {
    return rounded(unit.fromSi(range.low)) + " – " + withUnit(rounded(unit.fromSi(range.high)), unit);
}

std::string hardText(const Range& range, Quantity quantity) {
    const Unit& si = unitsOf(quantity).front();
    if (!std::isfinite(range.high) || si.name.empty()) return range.text();
    if (quantity == Quantity::angle) return withUnit(range.text(), si);
    const std::string high = inHandyUnit(range.high, quantity);
    return range.lowOpen ? "greater than 0, at most " + high
                         : inHandyUnit(range.low, quantity) + " – " + high;
}

std::string presenceText(Presence presence, std::string_view rival) {
    const std::string other = "`" + std::string(rival) + "`";
    switch (presence) {
        case Presence::required:
            return "required";
        case Presence::either:
            return rival.empty() ? "required, or what stands in its place" : "required, or " + other;
        case Presence::assumed:
        case Presence::unusual:
            return "may be left out: the program then assumes a value";
        case Presence::optional:
            return "may be left out";
    }
    return {};
}

std::string conditionText(Scope scope) {
    switch (scope) {
        case Scope::all:
        case Scope::section:
            return {};
        case Scope::withUnits:
            return "scenarios in physical units";
        case Scope::withoutUnits:
            return "dimensionless scenarios";
        case Scope::manyBlows:
            return "scenarios in physical units, for many blows: one alone does not depend on it";
        case Scope::string:
            return "drill strings";
        case Scope::hammer:
            return "drill strings that a hammer strikes";
        case Scope::uniformRod:
            return "uniform rods, with units and without";
        case Scope::dimensional:
            return "uniform rods in physical units";
        case Scope::withoutArea:
            return "uniform rods in physical units, given by their diameter";
        case Scope::givenPulse:
            return "hammer forces in physical units, but those of a piston or a table";
        case Scope::trapezoid:
            return "hammer forces of the shape `trapezoid`";
        case Scope::pistonInSi:
            return "hammer forces of the shape `piston`, in physical units";
        case Scope::pistonByRatio:
            return "hammer forces of the shape `piston`, dimensionless";
    }
    return {};
}

template <class Row>
ParameterFacts commonFacts(const Row& row) {
    return {.key = std::string(row.key),
            .label = std::string(row.label),
            .symbol = std::string(row.symbol),
            .meaning = std::string(row.meaning),
            .unit = std::string(row.unit),
            .range = hardText(row.hard, row.quantity),
            .usual = usualText(row.plausible, row.displayUnit()),
            .presence = {},
            .condition = {}};
}

}  // namespace

ParameterFacts factsOf(const Parameter& parameter) {
    ParameterFacts facts = commonFacts(parameter);
    if (parameter.rules.wholeNumber) facts.range = "a whole number " + facts.range;
    facts.presence = presenceText(parameter.rules.presence, parameter.rules.rival);
    const std::optional<RockLaw> law = parameter.rules.law;
    facts.condition =
        law ? "rock with `law: " + std::string(name(*law)) + "`" : conditionText(parameter.scope);
    return facts;
}

ParameterFacts factsOf(const SectionField& field) {
    ParameterFacts facts = commonFacts(field);
    facts.presence = presenceText(field.presence, {});
    return facts;
}

std::string titleOf(const ParameterFacts& facts) {
    return facts.symbol.empty() ? facts.label : facts.label + " " + facts.symbol;
}

std::vector<std::string> presetValues(const Parameter& parameter) {
    std::map<double, std::map<std::string, std::string>> values;  // by source: names of presets
    for (const Preset& preset : builtInPresets())
        for (const PresetValue& value : preset.values)
            if (value.parameter->key == parameter.key) {
                std::string& names = values[value.si][value.source];
                names += (names.empty() ? "" : "; ") + preset.name;
            }
    if (values.empty()) return {};
    const Unit& unit = parameter.displayUnit();
    const auto text = [&](double si) { return withUnit(rounded(unit.fromSi(si)), unit); };
    if (values.size() > mostPresetValues)
        return {text(values.begin()->first) + " to " + text(values.rbegin()->first) +
                ", of `drillwave presets`"};
    std::vector<std::string> lines;
    for (const auto& [si, sources] : values)
        for (const auto& [source, names] : sources)
            lines.push_back(text(si) + ": " + names + " (" + source + ")");
    return lines;
}

}  // namespace drillwave
