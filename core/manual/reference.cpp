// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/reference.h"

#include "core/manual/parameter_facts.h"
#include "core/model/parameter.h"
#include "core/report/report_numbers.h"

namespace drillwave {
namespace {

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

std::string sentence(std::string_view meaning, const ReadingStyle& style) {
    std::string shown = style.patternFor(std::string(meaning));
    constexpr char twoBytes =
        '\xc3';  // of "ä" and "å", whose capitals are as far from them as those of ASCII
    const std::size_t first = shown.starts_with(twoBytes) ? 1 : 0;
    const auto letter = static_cast<unsigned char>(shown.size() > first ? shown[first] : 0);
    if (first == 0 ? letter >= 'a' && letter <= 'z' : letter >= 0xa0 && letter <= 0xbe)
        shown[first] = static_cast<char>(letter - ('a' - 'A'));
    return shown + ".";
}

std::string entry(const ParameterFacts& facts, const std::vector<std::string>& values,
                  const ReadingStyle& style) {
    std::string text = heading(facts.key, facts.title) + facts.meaning + ".\n\n";
    text += item(translatable("unit"), facts.unit, style) + item(translatable("range"), facts.range, style) +
            item(translatable("usual"), facts.usual, style);
    for (const std::string& value : values) text += item(translatable("preset"), value, style);
    return text + item(translatable("of"), facts.condition, style) +
           item(translatable("in files"), facts.presence, style);
}

// What has a word, or true and false, for its value.
std::string wordEntry(std::string_view key, const Message& meaning, std::string_view values,
                      const ReadingStyle& style) {
    return heading(key, style.said(translatable("a word"))) + style.said(meaning) + ".\n\n" +
           item(translatable("one of"), values, style);
}

// Of the key of a parameter, as files have it.
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
            return translatable("drill strings that a hammer strikes");
        case OutputOf::elasticFaces:
            return translatable("drill strings whose faces have a stiffness");
    }
    return {};
}

// What is told by its key in every scenario, with those that words set.
std::string lawEntries(const ReadingStyle& style) {
    std::string text;
    for (const std::string_view key : {"bit_rock.corner.1.force", "bit_rock.corner.1.slope"})
        text += "\n" + referenceOf(*findParameter(key), style);
    return text;
}

}  // namespace

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
        text += " " + style.said({translatable("In the window: %1."), {Message::ofTable(output.note)}});
    text += "\n\n";
    const std::string scale = output.isOnlySi() ? style.said(translatable("nothing: it is there in SI only"))
                                                : std::string(scaleName(output));
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
        translatable(
            "Every number of a scenario: in files, behind `--set`, as axis of a study, as a field of the "
            "window. This chapter is written by the program from the table it works with. Outside its "
            "range a value is refused, outside the usual one it is remarked on; what presets give is a "
            "starting point, with its source. How files are written: files §1."),
        style);
    std::string last;
    for (const Parameter& parameter : parameters()) {
        const std::string title = section(sectionTitle(parameter.section()), style);
        if (title != last) text += title;
        last = title;
        text += "\n" + referenceOf(parameter, style);
    }
    text += section(translatable("Corners of the loading curve"), style) + "\n" +
            style.said(translatable("Up to 64 of them, by their place.")) + "\n" + lawEntries(style);
    text += section(translatable("Sections of a drill string"), style) + "\n" +
            style.said(translatable("NAME is the name of sections, or the place of one from 1; of the hammer "
                                    "`hammer.1.length` (files §1.3).")) +
            "\n";
    for (const SectionField& field : sectionFields()) text += "\n" + referenceOf(field, style);
    text += section(translatable("Words"), style);
    for (const WordParameter& parameter : wordParameters()) text += "\n" + referenceOf(parameter, style);
    return text + "\n" +
           wordEntry(restrikeKey,
                     translatable("Whether the hammer stays there to be hit again; without it the hammer is "
                                  "withdrawn after the first separation"),
                     "true, false", style);
}

std::string outputReference(const ReadingStyle& style) {
    std::string text = chapterHead(
        translatable("Outputs"),
        translatable(
            "Every result: a key of JSON, a column of CSV files, a name for `--outputs`, a row of the "
            "window. This chapter is written by the program from the table it works with. Scales are "
            "those of theory §2; of a drill string W0 and W are the energy E0 of its hammer, I0 the "
            "momentum p0."),
        style);
    text += section(translatable("One blow"), style);
    for (const Output& output : outputs()) text += "\n" + referenceOf(output, style);
    text += section(translatable("Many blows under a feed"), style);
    for (const Output& output : drillOutputs()) text += "\n" + referenceOf(output, style);
    return text;
}

}  // namespace drillwave
