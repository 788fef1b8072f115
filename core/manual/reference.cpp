// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/model/parameter.h"
#include "core/report/parameter_words.h"
#include "core/report/report_numbers.h"
#include "core/text/handy_text.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

namespace {

// Maximum number of values listed one by one; more are given as a range.
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
            if (rival.empty()) return translatable("required, or its alternative");
            return {translatable("required, or `%1`"), {std::string(rival)}};
        case Presence::assumed:
        case Presence::unusual:
            return translatable("optional; default value assumed");
        case Presence::optional:
            return translatable("optional");
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
            return translatable("scenarios in physical units; only for many blows");
        case Scope::string:
            return translatable("drill strings");
        case Scope::hammer:
            return translatable("drill strings struck by a hammer");
        case Scope::uniformRod:
            return translatable("uniform rods, with units and without");
        case Scope::dimensional:
            return translatable("uniform rods in physical units");
        case Scope::withoutArea:
            return translatable("uniform rods in physical units, given by their diameter");
        case Scope::givenPulse:
            return translatable("hammer forces in physical units, except piston and table");
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

constexpr std::string_view noUnit = "–";

std::string code(std::string_view name) {
    return "`" + std::string(name) + "`";
}

std::string heading(std::string_view name, std::string_view title) {
    return "### " + code(name) + ": " + std::string(title) + "\n\n";
}

std::string chapterHead(const Message& title, const Message& whatItHas, const ReadingStyle& style) {
    return "# " + style.said(title) + "\n\n" + style.said(whatItHas) + "\n";
}

std::string section(const Message& title, const ReadingStyle& style) {
    return "\n## " + style.said(title) + "\n";
}

std::string item(const Message& label, std::string_view text, const ReadingStyle& style) {
    return text.empty() ? std::string() : "- " + style.said(label) + ": " + std::string(text) + "\n";
}

/// Ends a text with a full stop; texts of several sentences have one already.
std::string stopped(std::string text) {
    while (text.ends_with('.')) text.pop_back();
    return text + ".";
}

std::string sentence(std::string_view meaning, const ReadingStyle& style) {
    std::string shown = style.patternFor(std::string(meaning));
    constexpr char twoBytes =
        '\xc3';  // of "ä" and "å", whose capitals are as far from them as those of ASCII
    const std::size_t first = shown.starts_with(twoBytes) ? 1 : 0;
    const auto letter = static_cast<unsigned char>(shown.size() > first ? shown[first] : 0);
    if (first == 0 ? letter >= 'a' && letter <= 'z' : letter >= 0xa0 && letter <= 0xbe)
        shown[first] = static_cast<char>(letter - ('a' - 'A'));
    return stopped(std::move(shown));
}

std::string entry(const ParameterFacts& facts, const std::vector<std::string>& values,
                  const ReadingStyle& style) {
    std::string text = heading(facts.key, facts.title) + stopped(facts.meaning) + "\n\n";
    text += item(translatable("unit"), facts.unit, style) + item(translatable("range"), facts.range, style) +
            item(translatable("usual"), facts.usual, style);
    for (const std::string& value : values) text += item(translatable("preset"), value, style);
    return text + item(translatable("of"), facts.condition, style) +
           item(translatable("in files"), facts.presence, style);
}

// Returns the entry of a parameter whose value is a word, or true or false.
std::string wordEntry(std::string_view key, const Message& meaning, std::string_view values,
                      const ReadingStyle& style) {
    return heading(key, style.said(translatable("a word"))) + stopped(style.said(meaning)) + "\n\n" +
           item(translatable("one of"), values, style);
}

// Returns the title of the section of a parameter, from its key in files.
Message sectionTitle(std::string_view section) {
    if (section == "rod") return translatable("Rod");
    if (section == "pulse") return translatable("Hammer force");
    if (section == "material") return translatable("Material of a drill string");
    if (section == "hammer") return translatable("Hammer of a drill string");
    if (section == "bit_rock") return translatable("Bit and rock");
    if (section == "drill") return translatable("Drill");
    if (section == "groups") return translatable("Groups");
    return translatable("Drill string");
}

Message meaningOf(const WordParameter& parameter) {
    if (parameter.key == pulseShapeKey) return translatable("Shape of the hammer force (files §1.1)");
    if (parameter.key == rockLawKey) return translatable("Loading curve of bit and rock (files §1.4)");
    return translatable("Whether every blow meets `fresh` rock or the `same` crater (drilling §4)");
}

Message ownersOf(const Output& output) {
    if (output.needsDrilling()) return translatable("many blows under a feed (drilling)");
    switch (output.of) {
        case OutputOf::anyBlow:
            return translatable("every blow");
        case OutputOf::uniformRod:
            return translatable("uniform rods");
        case OutputOf::drillString:
            return translatable("drill strings");
        case OutputOf::hammer:
            return translatable("drill strings struck by a hammer");
        case OutputOf::elasticFaces:
            return translatable("drill strings whose faces have a stiffness");
    }
    return {};
}

// Returns entries of keys that exist in every scenario, including those set by words.
std::string lawEntries(const ReadingStyle& style) {
    std::string text;
    for (const std::string_view key : {"bit_rock.corner.1.force", "bit_rock.corner.1.slope"})
        text += "\n" + referenceOf(*findParameter(key), style);
    return text;
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

std::string referenceOf(const Parameter& parameter, const ReadingStyle& style) {
    return entry(factsOf(parameter, style), presetValues(parameter, style), style);
}

std::string referenceOf(const SectionField& field, const ReadingStyle& style) {
    ParameterFacts facts = factsOf(field, style);
    facts.key = "string.NAME." + facts.key;
    return entry(facts, {}, style);
}

std::string referenceOf(const WordParameter& parameter, const ReadingStyle& style) {
    return wordEntry(parameter.key, meaningOf(parameter), parameter.list(), style);
}

std::string referenceOf(const Output& output, const ReadingStyle& style) {
    std::string text =
        heading(output.name, style.patternFor(std::string(output.title))) + sentence(output.meaning, style);
    if (!output.note.empty())
        text +=
            " " + stopped(style.said({translatable("In the window: %1."), {Message::ofTable(output.note)}}));
    text += "\n\n";
    const std::string scale =
        output.isOnlySi() ? style.said(translatable("none: only in SI")) : std::string(scaleName(output));
    if (scale == noUnit && siName(output) == noUnit)
        text += "- " + style.said(translatable("a plain number")) + "\n";
    else
        text += item(translatable("multiple of"), scale, style) +
                item(translatable("in SI"), siName(output), style);
    return text + item(translatable("of"), style.said(ownersOf(output)), style);
}

std::string_view scaleName(const Output& output) {
    const std::string_view name = multipleName(output.measure, Scenario());
    return name.empty() || output.measure == Measure::work ? noUnit : name;
}

std::string_view siName(const Output& output) {
    const std::string_view unit = unitsOf(output.siQuantity()).front().name;
    return unit.empty() ? noUnit : unit;
}

std::string parameterReference(const ReadingStyle& style) {
    std::string text = chapterHead(
        translatable("Parameters"),
        translatable("All parameters of a scenario: in files, after `--set`, as axis of a study, as a field "
                     "of the window. The program writes this chapter from its own table. A value outside its "
                     "range is refused; outside the usual range it gives a warning. Presets are starting "
                     "points with a source. Format of files: files §1."),
        style);
    std::string last;
    for (const Parameter& parameter : parameters()) {
        const std::string title = section(sectionTitle(parameter.section()), style);
        if (title != last) text += title;
        last = title;
        text += "\n" + referenceOf(parameter, style);
    }
    text += section(translatable("Corners of the loading curve"), style) + "\n" +
            style.said(translatable("Up to 64, by number.")) + "\n" + lawEntries(style);
    text += section(translatable("Sections of a drill string"), style) + "\n" +
            style.said(translatable("NAME is the name of sections, or the number of one, from 1; for the "
                                    "hammer, `hammer.1.length` (files §1.3).")) +
            "\n";
    for (const SectionField& field : sectionFields()) text += "\n" + referenceOf(field, style);
    text += section(translatable("Words"), style);
    for (const WordParameter& parameter : wordParameters()) text += "\n" + referenceOf(parameter, style);
    return text + "\n" +
           wordEntry(restrikeKey,
                     translatable("Whether the hammer may strike again; otherwise it is withdrawn after the "
                                  "first separation"),
                     "true, false", style);
}

std::string outputReference(const ReadingStyle& style) {
    std::string text = chapterHead(
        translatable("Outputs"),
        translatable("All results: keys of JSON, columns of CSV files, names for `--outputs`, rows of the "
                     "window. The program writes this chapter from its own table. Scales are those of theory "
                     "§2; for drill strings, W0 and W are the hammer energy E0 and I0 is the momentum p0."),
        style);
    text += section(translatable("One blow"), style);
    for (const Output& output : outputs()) text += "\n" + referenceOf(output, style);
    text += section(translatable("Many blows under a feed"), style);
    for (const Output& output : drillOutputs()) text += "\n" + referenceOf(output, style);
    return text;
}

}  // namespace drillwave
