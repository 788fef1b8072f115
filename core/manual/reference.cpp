// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/reference.h"

#include "core/manual/parameter_facts.h"
#include "core/model/parameter_table.h"
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

std::string item(std::string_view label, std::string_view text) {
    return text.empty() ? std::string() : "- " + std::string(label) + ": " + std::string(text) + "\n";
}

std::string capitalised(std::string_view text) {
    std::string shown(text);
    if (!shown.empty() && shown.front() >= 'a' && shown.front() <= 'z') shown.front() -= 'a' - 'A';
    return shown;
}

std::string entry(const ParameterFacts& facts, const std::vector<std::string>& values) {
    std::string text = heading(facts.key, titleOf(facts)) + facts.meaning + ".\n\n";
    text += item("unit", facts.unit) + item("range", facts.range) + item("usual", facts.usual);
    for (const std::string& value : values) text += item("preset", value);
    return text + item("of", facts.condition) + item("in files", facts.presence);
}

// Of the key of a parameter, as files have it.
std::string_view sectionTitle(std::string_view section) {
    if (section == "rod") return "Rod";
    if (section == "pulse") return "Hammer force";
    if (section == "material") return "Material of a drill string";
    if (section == "hammer") return "Hammer of a drill string";
    if (section == "bit_rock") return "Bit and rock";
    if (section == "drill") return "Drill";
    if (section == "groups") return "Groups";
    return "Drill string";
}

std::string_view meaningOf(const WordParameter& parameter) {
    if (parameter.key == pulseShapeKey) return "Shape of the hammer force (files §1.1)";
    if (parameter.key == rockLawKey) return "Loading curve of bit and rock (files §1.4)";
    return "Whether every blow meets `fresh` rock or the `same` crater (drilling §4)";
}

std::string_view ownersOf(OutputOf of) {
    switch (of) {
        case OutputOf::anyBlow:
            return "every blow";
        case OutputOf::uniformRod:
            return "uniform rods";
        case OutputOf::drillString:
            return "drill strings";
        case OutputOf::hammer:
            return "drill strings that a hammer strikes";
        case OutputOf::elasticFaces:
            return "drill strings whose faces have a stiffness";
    }
    return {};
}

// What is told by its key in every scenario, with those that words set.
std::string lawEntries() {
    std::string text;
    for (const std::string_view key : {"bit_rock.corner.1.force", "bit_rock.corner.1.slope"})
        text += "\n" + referenceOf(*findParameter(key));
    return text;
}

}  // namespace

std::string referenceOf(const Parameter& parameter) {
    return entry(factsOf(parameter), presetValues(parameter));
}

std::string referenceOf(const SectionField& field) {
    ParameterFacts facts = factsOf(field);
    facts.key = "string.NAME." + facts.key;
    return entry(facts, {});
}

std::string referenceOf(const WordParameter& parameter) {
    return heading(parameter.key, "a word") + std::string(meaningOf(parameter)) + ".\n\n" +
           item("one of", parameter.list());
}

std::string referenceOf(const Output& output) {
    std::string text = heading(output.name, output.title) + capitalised(output.meaning) + ".";
    if (!output.note.empty()) text += " In the window: " + std::string(output.note) + ".";
    text += "\n\n";
    const bool isPlain = scaleName(output) == noUnit && siName(output) == noUnit;
    text += isPlain ? "- a plain number\n"
                    : item("multiple of", scaleName(output)) + item("in SI", siName(output));
    return text +
           item("of", output.needsDrilling() ? "many blows under a feed (drilling)" : ownersOf(output.of));
}

std::string_view scaleName(const Output& output) {
    if (output.isOnlySi()) return "SI only";
    const std::string_view name = multipleName(output.measure, Scenario());
    return name.empty() || output.measure == Measure::work ? noUnit : name;
}

std::string_view siName(const Output& output) {
    const std::string_view unit = unitsOf(output.quantity()).front().name;
    return unit.empty() ? noUnit : unit;
}

std::string parameterReference() {
    std::string text =
        "# Parameters\n\nEvery number of a scenario: in files, behind `--set`, as axis of a study, as a "
        "field of "
        "the window. This chapter is written by the program from the table it works with. Outside its "
        "range a value is refused, outside the usual one it is remarked on; what presets give is a starting "
        "point, with its source. How files are written: files §1.\n";
    std::string_view section;
    for (const Parameter& parameter : parameters()) {
        const std::string_view title = sectionTitle(parameter.section());
        if (title != section) text += "\n## " + std::string(title) + "\n";
        section = title;
        text += "\n" + referenceOf(parameter);
    }
    text += "\n## Corners of the loading curve\n\nUp to 64 of them, by their place.\n" + lawEntries();
    text +=
        "\n## Sections of a drill string\n\nNAME is the name of sections, or the place of one from 1; of the "
        "hammer "
        "`hammer.1.length` (files §1.3).\n";
    for (const SectionField& field : sectionFields()) text += "\n" + referenceOf(field);
    text += "\n## Words\n";
    for (const WordParameter& parameter : wordParameters()) text += "\n" + referenceOf(parameter);
    return text + "\n" + heading(restrikeKey, "a word") +
           "Whether the hammer stays there to be hit again; without it the hammer is withdrawn after the "
           "first "
           "separation.\n\n" +
           item("one of", "true, false");
}

std::string outputReference() {
    std::string text =
        "# Outputs\n\nEvery result: a key of JSON, a column of CSV files, a name for `--outputs`, a row of "
        "the "
        "window. This chapter is written by the program from the table it works with. Scales are those of "
        "theory §2; of a drill string W0 and W are its energy E0, I0 its momentum p0.\n\n## One blow\n";
    for (const Output& output : outputs()) text += "\n" + referenceOf(output);
    text += "\n## Many blows under a feed\n";
    for (const Output& output : drillOutputs()) text += "\n" + referenceOf(output);
    return text;
}

}  // namespace drillwave
