// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/scenario_reader.h"

#include <charconv>

#include "core/file/pulse_reader.h"
#include "core/file/section_reader.h"
#include "core/model/parameter.h"

namespace drillwave {
namespace {

using Kind = YamlNode::Kind;
using Applicability = SectionReader::Applicability;

/// False for a file of a newer format, whose keys mean nothing to this program.
bool readFormat(SectionReader& reader, const YamlNode& root) {
    const std::vector<YamlNode>& children = root.children;
    std::size_t at = 0;
    while (at < children.size() && children[at].text != "drillwave") at += 2;
    ProblemList& problems = reader.problems();
    const std::string expected = "`drillwave: " + std::to_string(scenarioFormat) + "`";
    if (at >= children.size()) {
        problems.reportKey(root.offset, "drillwave", "is missing: the first line must be " + expected);
        return true;
    }
    if (at > 0) problems.reportKey(children[at].offset, "drillwave", "must be the first key of the file");

    const YamlEntry entry{&children[at], &children[at + 1]};
    const std::string& text = entry.value->text;
    long format = 0;
    const auto number = std::from_chars(text.data(), text.data() + text.size(), format);
    const bool whole = !text.empty() && number.ptr == text.data() + text.size();
    if (whole && (number.ec == std::errc::result_out_of_range || format > scenarioFormat) &&
        text.front() != '-') {
        problems.reportValue(entry.place(), "drillwave", text,
                             "this file says drillwave: " + text.substr(0, 20) +
                                 "; this program reads up to " + std::to_string(scenarioFormat) +
                                 ", use a newer one");
        return false;
    }
    if (text != std::to_string(scenarioFormat))
        problems.reportValue(entry.place(), "drillwave", text,
                             "the format number must be " + std::to_string(scenarioFormat));
    return true;
}

void readTitle(SectionReader& reader, const YamlEntries& file) {
    const auto found = file.find("title");
    if (found == file.end() || found->second.value->kind == Kind::null) return;
    if (found->second.value->kind != Kind::scalar)
        reader.problems().reportKey(found->second.place(), "title", "must be text");
    reader.scenario().title = found->second.value->text;
}

void readGroups(SectionReader& reader, const YamlEntries& file) {
    for (const std::string_view name : {"rod", "bit_rock", "drill"})
        if (const auto found = file.find(name); found != file.end())
            reader.problems().reportKey(found->second.key->offset, name,
                                        "cannot stand beside `dimensionless`: give one or the other");
    const std::optional<YamlEntries> entries = reader.section(file, "dimensionless", "groups");
    if (!entries) return;
    reader.readParameters(*entries, "groups", Applicability::checked);
    reader.requireParameters(*entries, "groups");
}

void readRod(SectionReader& reader, const YamlEntries& file) {
    const std::optional<YamlEntries> entries = reader.section(file, "rod", "rod");
    if (!entries) return;
    reader.readParameters(*entries, "rod", Applicability::ignored);
    reader.requireParameters(*entries, "rod");
    const auto bore = entries->find("bore");
    if (entries->contains("area") && !entries->contains("diameter") && bore != entries->end())
        reader.problems().reportKey(bore->second.key->offset, "rod.bore",
                                    "goes with a diameter, not with an area");
}

void readBitRock(SectionReader& reader, const YamlEntries& file) {
    const std::optional<YamlEntries> entries = reader.section(file, "bit_rock", "bit_rock");
    if (!entries) return;
    reader.readParameters(*entries, "bit_rock", Applicability::checked);
    reader.requireParameters(*entries, "bit_rock");
}

void readDrill(SectionReader& reader, const YamlEntries& file) {
    if (!file.contains("drill")) return;
    const std::optional<YamlEntries> entries = reader.section(file, "drill", "drill");
    if (!entries) return;
    reader.readParameters(*entries, "drill", Applicability::checked);
    reader.requireParameters(*entries, "drill");
}

/// Whether a finding of validate() is about values that were read: a default that stands in for a bad or
/// missing value must raise no alarm.
bool isAboutTheFile(SectionReader& reader, const InputProblem& problem) {
    const auto read = [&](std::string_view key) {
        return reader.placeOf(key).has_value() && !reader.problems().concerns(key);
    };
    if (problem.key == "rod.bore") return read("rod.diameter") && read("rod.bore");
    if (problem.key == "pulse.fall")
        return !reader.problems().concerns("pulse.rise") && !reader.problems().concerns("pulse.fall");
    return problem.key == "pulse.points" && read("pulse.points") && !reader.problems().concerns("pulse.file");
}

/// Where a group comes from in a dimensional scenario.
std::string_view originOf(std::string_view key) {
    const Parameter* parameter = findParameter(key);
    return parameter && parameter->isGroup() ? parameter->rules.rival : key;
}

void checkWhole(SectionReader& reader) {
    const bool clean = reader.problems().empty();
    for (InputProblem& problem : validate(reader.scenario())) {
        if (!clean && !isAboutTheFile(reader, problem)) continue;
        const std::optional<std::size_t> place =
            reader.placeOf(reader.dimensional() ? originOf(problem.key) : problem.key);
        const TextPosition at = reader.problems().position(place.value_or(0));
        problem.line = at.line;
        problem.column = at.column;
        reader.problems().report(std::move(problem));
    }
}

/// True when all that is wrong is an unreadable table file.
bool readSections(SectionReader& reader, const YamlNode& root, const TableSource& tables) {
    const YamlEntries file = reader.entriesOf(
        root, "", {"drillwave", "title", "dimensionless", "rod", "pulse", "bit_rock", "drill"});
    const bool dimensionless = file.contains("dimensionless");
    reader.scenario().form = dimensionless ? ScenarioForm::dimensionless : ScenarioForm::dimensional;
    readTitle(reader, file);
    if (dimensionless) {
        readGroups(reader, file);
    } else {
        readRod(reader, file);
        readBitRock(reader, file);
        readDrill(reader, file);
    }
    const bool unreadable = readPulse(reader, file, tables);
    checkWhole(reader);
    return unreadable;
}

ReadScenario unreadableText(InputProblem problem) {
    ReadScenario result;
    result.unreadable = true;
    result.problems.push_back(std::move(problem));
    return result;
}

}  // namespace

ReadScenario readScenario(std::string_view text, const std::string& source, const TablePoints* tablePoints) {
    if (const TextProblem problem = checkText(text); !problem.reason.empty()) {
        const TextPosition at = positionOf(text, problem.offset);
        return unreadableText({"", "is not a text file: it holds " + problem.reason, at.line, at.column});
    }
    const YamlTree tree = parseYaml(text);
    if (!tree.problem.text.empty()) {
        const TextPosition at = positionOf(text, tree.problem.offset);
        ReadScenario result = unreadableText({"", tree.problem.text, at.line, at.column});
        result.unreadable = !tree.problem.isYaml;
        return result;
    }
    if (tree.root.kind == Kind::null) return unreadableText({"", "the file is empty", 1, 1});

    SectionReader reader(text);
    ReadScenario result;
    if (tree.root.kind != Kind::map)
        reader.problems().reportKey(tree.root.offset, "drillwave",
                                    "the file must be lines of `key: value`, the first `drillwave: 1`");
    else if (readFormat(reader, tree.root))
        result.unreadable = readSections(reader, tree.root, {source, tablePoints});
    result.problems = reader.problems().take();
    result.scenario = std::move(reader.scenario());
    return result;
}

}  // namespace drillwave
