// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/scenario_text.h"

#include <algorithm>

#include "core/file/scenario_reader.h"
#include "core/model/scales.h"

namespace drillwave {
namespace {

/// A mean force is kept as such if it leads back to the same impulse, as every force that was given does.
bool keepsForce(const Pulse& pulse) {
    return pulse.impulseFromForce && meanForce(pulse) * pulse.duration == pulse.impulse;
}

bool isSaved(const Parameter& parameter, const Scenario& scenario) {
    if (parameter.key == "pulse.impulse") return parameter.applies(scenario) && !keepsForce(scenario.pulse);
    if (parameter.key == "pulse.force") return parameter.applies(scenario) && keepsForce(scenario.pulse);
    return isGiven(parameter, scenario) && parameter.value(scenario).has_value();
}

SavedValue savedParameter(const Parameter& parameter, const Scenario& scenario) {
    const double number = *parameter.value(scenario);
    const Presence presence = parameter.rules.presence;
    const bool mayBeMissing = presence == Presence::assumed || presence == Presence::unusual;
    return {parameter.fileSection(),
            parameter.localKey(),
            &parameter,
            number,
            {},
            mayBeMissing && number == parameter.value(Scenario())};
}

SavedValue savedText(std::string_view section, std::string_view key, std::string_view text) {
    return {section, key, nullptr, 0, std::string(text), false};
}

/// "[0 us, 0 kN]"; "[0, 0]" in a dimensionless scenario.
std::string pointText(const TablePoint& point, ScenarioForm form) {
    const bool dimensional = form == ScenarioForm::dimensional;
    const auto text = [&](double value, Quantity quantity, std::string_view unit) {
        const Quantity kind = dimensional ? quantity : Quantity::ratio;
        return formatQuantity(value, kind, *findUnit(kind, dimensional ? unit : ""));
    };
    return "[" + text(point.time, Quantity::time, "us") + ", " + text(point.force, Quantity::force, "kN") +
           "]";
}

std::string pointsText(const Scenario& scenario) {
    std::string text = "  points:\n";
    for (const TablePoint& point : scenario.pulse.tablePoints)
        text += "    - " + pointText(point, scenario.form) + "\n";
    return text;
}

bool hasInlinePoints(const Scenario& scenario) {
    return scenario.pulse.shape == PulseShape::table && scenario.pulse.tableFile.empty();
}

/// A usual value that a new file does not tell.
bool goesWithoutSaying(const SavedValue& value) {
    return value.isDefault && value.parameter->rules.presence == Presence::unusual;
}

bool isNullWord(std::string_view text) {
    return text == "~" || text == "null" || text == "Null" || text == "NULL";
}

bool isPlainScalar(std::string_view text) {
    constexpr std::string_view indicators = "-?:,[]{}#&*!|>'\"%@` \t";
    if (text.empty() || isNullWord(text) || indicators.find(text.front()) != std::string_view::npos)
        return false;
    if (text.back() == ' ' || text.back() == ':' || text.starts_with("...")) return false;
    if (text.find(": ") != std::string_view::npos || text.find(" #") != std::string_view::npos) return false;
    return std::ranges::none_of(text,
                                [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

std::string quotedScalar(std::string_view text) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            quoted += std::string("\\") + c;
        else if (c == '\n')
            quoted += "\\n";
        else if (byte < 0x20 || byte == 0x7F)
            quoted += std::string("\\x") + hex[byte / 16] + hex[byte % 16];
        else
            quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

std::vector<SavedValue> savedValues(const Scenario& scenario) {
    std::vector<SavedValue> values;
    if (!scenario.title.empty()) values.push_back(savedText("", "title", scenario.title));
    const bool dimensional = scenario.form == ScenarioForm::dimensional;
    for (const std::string_view section :
         {dimensional ? "rod" : "dimensionless", "pulse", "bit_rock", "drill"}) {
        if (section == "pulse") values.push_back(savedText("pulse", "shape", name(scenario.pulse.shape)));
        for (const Parameter& parameter : parameters())
            if (parameter.fileSection() == section && isSaved(parameter, scenario))
                values.push_back(savedParameter(parameter, scenario));
        if (section == "pulse" && scenario.pulse.shape == PulseShape::table &&
            !scenario.pulse.tableFile.empty())
            values.push_back(savedText("pulse", "file", scenario.pulse.tableFile));
    }
    return values;
}

Scenario withoutUnusedValues(const Scenario& scenario) {
    Scenario result;
    result.title = scenario.title;
    result.form = scenario.form;
    result.pulse.shape = scenario.pulse.shape;
    for (const SavedValue& value : savedValues(scenario))
        if (value.parameter) value.parameter->assign(result, value.number);
    if (scenario.pulse.shape == PulseShape::table) {
        result.pulse.tableFile = scenario.pulse.tableFile;
        result.pulse.tablePoints = scenario.pulse.tablePoints;
    }
    return result;
}

std::string valueText(const SavedValue& value, const Unit* unit) {
    if (!value.parameter) return yamlScalar(value.text);
    return formatQuantity(value.number, value.parameter->quantity,
                          unit ? *unit : value.parameter->displayUnit());
}

std::string yamlScalar(std::string_view text) {
    return isPlainScalar(text) ? std::string(text) : quotedScalar(text);
}

std::string sectionText(const Scenario& scenario, std::string_view section) {
    const bool points = section == "pulse" && hasInlinePoints(scenario);
    const bool flow = scenario.form == ScenarioForm::dimensionless && !points;
    std::string lines;
    for (const SavedValue& value : savedValues(scenario)) {
        if (value.section != section || goesWithoutSaying(value)) continue;
        const std::string line = std::string(value.key) + ": " + valueText(value);
        lines += flow ? (lines.empty() ? "" : ", ") + line : "  " + line + "\n";
    }
    if (points) lines += pointsText(scenario);
    if (lines.empty()) return {};
    return std::string(section) + (flow ? ": {" + lines + "}\n" : ":\n" + lines);
}

std::string scenarioText(const Scenario& scenario) {
    std::string text = "drillwave: " + std::to_string(scenarioFormat) + "\n";
    if (!scenario.title.empty()) text += "title: " + yamlScalar(scenario.title) + "\n";
    const bool dimensional = scenario.form == ScenarioForm::dimensional;
    for (const std::string_view section :
         {dimensional ? "rod" : "dimensionless", "pulse", "bit_rock", "drill"})
        text += sectionText(scenario, section);
    return text;
}

}  // namespace drillwave
