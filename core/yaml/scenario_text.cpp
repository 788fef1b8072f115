// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_text.h"

#include <algorithm>
#include <limits>

#include "core/model/blow_traits.h"
#include "core/model/law_parameter.h"
#include "core/model/scales.h"
#include "core/model/section_field.h"
#include "core/yaml/scenario_reader.h"

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
    return {.section = std::string(parameter.fileSection()),
            .key = parameter.localKey(),
            .unit = SavedUnit{parameter.quantity, &parameter.displayUnit()},
            .number = number,
            .text = {},
            .isDefault = mayBeMissing && number == parameter.value(Scenario()),
            .isUnusual = presence == Presence::unusual,
            .parameter = &parameter};
}

SavedValue savedText(std::string_view section, std::string_view key, std::string_view text) {
    return {.section = std::string(section), .key = key, .unit = {}, .text = std::string(text)};
}

void addSection(std::vector<SavedValue>& values, const std::string& path, const Section& section) {
    if (!section.name.empty()) values.push_back(savedText(path, "name", section.name));
    if (!section.preset.empty()) values.push_back(savedText(path, "preset", section.preset));
    for (const SectionField& field : sectionFields()) {
        const std::optional<double> value = field.value(section);
        if (!value) continue;
        const bool isUnusual = field.presence == Presence::unusual;
        values.push_back({.section = path,
                          .key = field.key,
                          .unit = SavedUnit{field.quantity, &field.displayUnit()},
                          .number = *value,
                          .text = {},
                          .isDefault = isUnusual && value == field.value(Section()),
                          .isUnusual = isUnusual});
    }
}

void addSections(std::vector<SavedValue>& values, const std::string& path,
                 const std::vector<Section>& sections) {
    for (std::size_t i = 0; i < sections.size(); ++i)
        addSection(values, path + "." + std::to_string(i), sections[i]);
}

void addParameters(std::vector<SavedValue>& values, const Scenario& scenario, std::string_view section) {
    for (const Parameter& parameter : parameters())
        if (parameter.fileSection() == section && isSaved(parameter, scenario))
            values.push_back(savedParameter(parameter, scenario));
}

void addHammer(std::vector<SavedValue>& values, const Scenario& scenario) {
    const Hammer& hammer = scenario.drillString.hammer;
    addParameters(values, scenario, "hammer");
    SavedValue restrike = savedText("hammer", "restrike", hammer.restrike ? "true" : "false");
    restrike.isDefault = hammer.restrike;
    restrike.isUnusual = true;
    values.push_back(restrike);
    addSections(values, "hammer.sections", hammer.sections);
}

void addDrillString(std::vector<SavedValue>& values, const Scenario& scenario) {
    const DrillString& drillString = scenario.drillString;
    addParameters(values, scenario, "");
    addParameters(values, scenario, "material");
    if (!isForced(scenario)) addHammer(values, scenario);
    for (std::size_t i = 0; i < drillString.parts.size(); ++i) {
        const StringPart& part = drillString.parts[i];
        const std::string path = "string." + std::to_string(i);
        if (!part.group) {
            addSection(values, path, part.sections.front());
            continue;
        }
        values.push_back({.section = path,
                          .key = "repeat",
                          .unit = SavedUnit{Quantity::ratio, &unitsOf(Quantity::ratio).front()},
                          .number = static_cast<double>(part.repeat),
                          .text = {}});
        addSections(values, path + ".of", part.sections);
    }
}

/// A number of an item of a list.
SavedValue savedCorner(const std::string& path, const Parameter& parameter, const Scenario& scenario) {
    return {.section = path,
            .key = parameter.key.substr(parameter.key.rfind('.') + 1),
            .unit = SavedUnit{parameter.quantity, &parameter.displayUnit()},
            .number = parameter.value(scenario).value_or(std::numeric_limits<double>::quiet_NaN()),
            .text = {}};
}

/// The loading curve of the rock, beside the numbers of the table of parameters.
void addLaw(std::vector<SavedValue>& values, const Scenario& scenario) {
    const BitRock& rock = scenario.bitRock;
    SavedValue law = savedText("bit_rock", "law", name(rock.law));
    law.isDefault = rock.law == RockLaw::bilinear;
    law.isUnusual = true;
    values.push_back(law);
    for (const KeptParameter& parameter : loadingNumbers(scenario)) {
        const std::size_t corner = cornerOf(*parameter);
        values.push_back(corner == 0
                             ? savedParameter(*parameter, scenario)
                             : savedCorner(std::string(cornersPath) + "." + std::to_string(corner - 1),
                                           *parameter, scenario));
    }
}

/// Adds the indexing of the rock; not if the scenario has no data of the drill.
void addIndexing(std::vector<SavedValue>& values, const Scenario& scenario) {
    if (scenario.drill == Drill()) return;
    SavedValue indexing = savedText("drill", "indexing", name(scenario.drill.indexing));
    indexing.isDefault = scenario.drill.indexing == RockIndexing::fresh;
    indexing.isUnusual = true;
    values.push_back(indexing);
}

/// The sections of a file, in order, that are no lists.
std::vector<std::string_view> plainSections(const Scenario& scenario) {
    std::vector<std::string_view> sections;
    if (!hasSections(scenario)) sections.emplace_back(hasUnits(scenario) ? "rod" : "dimensionless");
    if (isForced(scenario)) sections.emplace_back("pulse");
    if (hasUnits(scenario) || scenario.bitRock.law != RockLaw::bilinear) sections.emplace_back("bit_rock");
    sections.emplace_back("drill");
    return sections;
}

/// "[0 us, 0 kN]"; "[0, 0]" in a dimensionless scenario.
std::string pointText(const TablePoint& point, bool dimensional) {
    const auto text = [&](double value, Quantity quantity, std::string_view unit) {
        const Quantity kind = dimensional ? quantity : Quantity::ratio;
        return formatQuantity(value, kind, *findUnit(kind, dimensional ? unit : ""));
    };
    return "[" + text(point.time, Quantity::time, "us") + ", " + text(point.force, Quantity::force, "kN") +
           "]";
}

bool hasInlinePoints(const Scenario& scenario) {
    return scenario.pulse.shape == PulseShape::table && scenario.pulse.tableFile.empty();
}

/// A usual value that a new file does not tell.
bool goesWithoutSaying(const SavedValue& value) {
    return value.isDefault && value.isUnusual;
}

/// "length: 3660 mm, diameter: 39 mm" of the values of one section of a file.
std::string flowEntries(const std::vector<SavedValue>& values, std::string_view section) {
    std::string text;
    for (const SavedValue& value : values)
        if (value.section == section && !goesWithoutSaying(value))
            text += (text.empty() ? "" : ", ") + std::string(value.key) + ": " + valueText(value);
    return text;
}

std::string blockEntries(const std::vector<SavedValue>& values, std::string_view section) {
    std::string text;
    for (const SavedValue& value : values)
        if (value.section == section && !goesWithoutSaying(value))
            text += "  " + std::string(value.key) + ": " + valueText(value) + "\n";
    return text;
}

/// The sections or corners of a list, one item each.
std::vector<std::string> mapItems(const std::vector<SavedValue>& values, const std::string& path,
                                  std::size_t count) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(sectionItem(values, path + "." + std::to_string(i)));
    return items;
}

std::vector<std::string> partItems(const Scenario& scenario) {
    const std::vector<SavedValue> values = savedValues(scenario);
    std::vector<std::string> items;
    for (std::size_t i = 0; i < scenario.drillString.parts.size(); ++i) {
        const StringPart& part = scenario.drillString.parts[i];
        const std::string path = "string." + std::to_string(i);
        items.push_back(part.group ? "repeat: " + std::to_string(part.repeat) + "\nof:\n" +
                                         listText(mapItems(values, path + ".of", part.sections.size()), 2)
                                   : sectionItem(values, path));
        if (part.group) items.back().pop_back();
    }
    return items;
}

/// Empty for a uniform rod.
std::string drillStringText(const Scenario& scenario) {
    if (listItems(scenario, "string").empty()) return {};
    return sectionText(scenario, "material") +
           sectionText(scenario, isForced(scenario) ? "pulse" : "hammer") + sectionText(scenario, "string");
}

Section withoutUnusedValues(Section section) {
    if (section.area) section.diameter = 0;
    for (const SectionField& field : sectionFields()) {
        if (field.applies(section)) continue;
        if (field.clear)
            field.clear(section);
        else
            field.assign(section, 0);
    }
    return section;
}

DrillString withoutUnusedValues(DrillString drillString) {
    for (Section& section : drillString.hammer.sections) section = withoutUnusedValues(std::move(section));
    for (StringPart& part : drillString.parts)
        for (Section& section : part.sections) section = withoutUnusedValues(std::move(section));
    return drillString;
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
    addDrillString(values, scenario);
    for (const std::string_view section : plainSections(scenario)) {
        if (section == "pulse") values.push_back(savedText("pulse", "shape", name(scenario.pulse.shape)));
        addParameters(values, scenario, section);
        if (section == "bit_rock") addLaw(values, scenario);
        if (section == "drill" && hasUnits(scenario)) addIndexing(values, scenario);
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
    result.drillString = withoutUnusedValues(scenario.drillString);
    if (isForced(scenario)) result.pulse.shape = scenario.pulse.shape;
    result.bitRock.law = scenario.bitRock.law;
    if (scenario.bitRock.law == RockLaw::corners) result.bitRock.corners = scenario.bitRock.corners;
    for (const SavedValue& value : savedValues(scenario))
        if (value.parameter) value.parameter->assign(result, value.number);
    if (isForced(scenario) && scenario.pulse.shape == PulseShape::table) {
        result.pulse.tableFile = scenario.pulse.tableFile;
        result.pulse.tablePoints = scenario.pulse.tablePoints;
    }
    return result;
}

std::string valueText(const SavedValue& value, const Unit* unit) {
    // A section of a list may stand in braces, where more characters mean something.
    const bool inList = value.section.find('.') != std::string::npos;
    if (!value.unit && inList && value.text.find_first_of(",[]{}:?") != std::string::npos)
        return quotedScalar(value.text);
    if (!value.unit) return yamlScalar(value.text);
    return formatQuantity(value.number, value.unit->quantity, unit ? *unit : *value.unit->customary);
}

std::string yamlScalar(std::string_view text) {
    return isPlainScalar(text) ? std::string(text) : quotedScalar(text);
}

std::string sectionItem(const std::vector<SavedValue>& values, std::string_view path) {
    return "{" + flowEntries(values, path) + "}";
}

std::string listText(const std::vector<std::string>& items, std::size_t indentation) {
    const std::string blanks(indentation, ' ');
    std::string text;
    for (const std::string& item : items) {
        text += blanks + "- ";
        for (const char c : item) {
            text += c;
            if (c == '\n') text += blanks + "  ";
        }
        text += '\n';
    }
    return text;
}

std::vector<std::string> listItems(const Scenario& scenario, std::string_view list) {
    const DrillString& drillString = scenario.drillString;
    if (list == "string") return partItems(scenario);
    std::vector<std::string> points;
    if (list == pointsPath && hasInlinePoints(scenario))
        for (const TablePoint& point : scenario.pulse.tablePoints)
            points.push_back(pointText(point, hasUnits(scenario)));
    if (list == pointsPath) return points;
    const std::size_t count = list == hammerSectionsPath                 ? drillString.hammer.sections.size()
                              : scenario.bitRock.law == RockLaw::corners ? scenario.bitRock.corners.size()
                                                                         : 0;
    return mapItems(savedValues(scenario), std::string(list), count);
}

std::string sectionText(const Scenario& scenario, std::string_view section) {
    if (section == "material") return "material: {" + flowEntries(savedValues(scenario), section) + "}\n";
    if (section == "string") return "string:\n" + listText(listItems(scenario, section), 2);
    if (section == "hammer")
        return "hammer:\n" + blockEntries(savedValues(scenario), section) + "  sections:\n" +
               listText(listItems(scenario, hammerSectionsPath), 4);
    const std::vector<std::string> points =
        section == "pulse" ? listItems(scenario, pointsPath) : std::vector<std::string>();
    const std::vector<std::string> corners =
        section == "bit_rock" ? listItems(scenario, cornersPath) : std::vector<std::string>();
    const bool flow = scenario.form == ScenarioForm::dimensionless && points.empty() && corners.empty();
    const std::vector<SavedValue> values = savedValues(scenario);
    std::string lines;
    for (const SavedValue& value : values) {
        if (value.section != section || goesWithoutSaying(value)) continue;
        const std::string line = std::string(value.key) + ": " + valueText(value);
        lines += flow ? (lines.empty() ? "" : ", ") + line : "  " + line + "\n";
    }
    if (!points.empty()) lines += "  points:\n" + listText(points, 4);
    if (!corners.empty()) lines += "  corners:\n" + listText(corners, 4);
    if (lines.empty()) return {};
    return std::string(section) + (flow ? ": {" + lines + "}\n" : ":\n" + lines);
}

std::string scenarioText(const Scenario& scenario) {
    const std::string ofString = drillStringText(scenario);
    std::string text = "drillwave: " + std::to_string(ofString.empty() ? rodFormat : stringFormat) + "\n";
    if (!scenario.title.empty()) text += "title: " + yamlScalar(scenario.title) + "\n";
    for (const SavedValue& value : savedValues(scenario))
        if (value.section.empty() && value.parameter)
            text += std::string(value.key) + ": " + valueText(value) + "\n";
    text += ofString;
    for (const std::string_view section : plainSections(scenario))
        if (section != "pulse" || ofString.empty()) text += sectionText(scenario, section);
    return text;
}

}  // namespace drillwave
