// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_reader.h"

#include <algorithm>
#include <charconv>
#include <span>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/yaml/design_setup_text.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/pulse_reader.h"
#include "core/yaml/section_reader.h"
#include "core/yaml/string_reader.h"

namespace drillwave {
namespace {

using Applicability = SectionReader::Applicability;

constexpr std::string_view stringKeys[] = {"material", "hammer", "string", "end_time"};
constexpr std::string_view rodKeys[] = {"dimensionless", "rod"};
/// Key of the one word in a drill.
constexpr std::string_view indexingKey = "indexing";

constexpr std::string_view commonKeys[] = {"drillwave", "title", "pulse", "bit_rock", "drill", designKey};

/// The keys at the top level that a format has and the other one has not.
std::span<const std::string_view> keysOf(int format) {
    return format == rodFormat ? std::span<const std::string_view>(rodKeys) : stringKeys;
}

std::size_t indexOf(const YamlNode& root, std::string_view key) {
    std::size_t at = 0;
    while (at < root.children.size() && root.children[at].text != key) at += 2;
    return at;
}

bool hasOneOf(const YamlNode& root, std::span<const std::string_view> keys) {
    return std::ranges::any_of(
        keys, [&](std::string_view key) { return indexOf(root, key) < root.children.size(); });
}

/// The number of the format that the keys would have, where the file does not say it.
int likelyFormat(const YamlNode& root) {
    return hasOneOf(root, stringKeys) && !hasOneOf(root, rodKeys) ? stringFormat : rodFormat;
}

/// The format of the file; nothing for a newer one, whose keys mean nothing to this program.
std::optional<int> readFormat(SectionReader& reader, const YamlNode& root) {
    const std::vector<YamlNode>& children = root.children;
    const std::size_t at = indexOf(root, "drillwave");
    ProblemList& problems = reader.problems();
    const int likely = likelyFormat(root);
    if (at >= children.size()) {
        problems.reportKey(
            root.offset, "drillwave",
            {translatable("is missing: the first line must be `drillwave: %1`"), {std::to_string(likely)}});
        return likely;
    }
    if (at > 0)
        problems.reportKey(children[at].offset, "drillwave",
                           translatable("must be the first key of the file"));

    const YamlEntry entry{&children[at], &children[at + 1]};
    const std::string& text = entry.value->text;
    long format = 0;
    const auto number = std::from_chars(text.data(), text.data() + text.size(), format);
    const bool whole = !text.empty() && number.ptr == text.data() + text.size();
    if (whole && (number.ec == std::errc::result_out_of_range || format > newestFormat) &&
        text.front() != '-') {
        problems.reportValue(entry.place(), "drillwave", text,
                             {translatable("this file says drillwave: %1; this program reads up to %2, use a "
                                           "newer one"),
                              {text.substr(0, 20), std::to_string(newestFormat)}});
        return std::nullopt;
    }
    for (const int known : {rodFormat, stringFormat})
        if (text == std::to_string(known)) return known;
    problems.reportValue(entry.place(), "drillwave", text,
                         {translatable("the format number must be %1 for a uniform rod or %2 for a drill "
                                       "string"),
                          {std::to_string(rodFormat), std::to_string(stringFormat)}});
    return likely;
}

void readTitle(SectionReader& reader, const YamlEntries& file) {
    const auto found = file.find("title");
    if (found == file.end() || found->second.value->kind == YamlKind::null) return;
    if (found->second.value->kind != YamlKind::scalar)
        reader.problems().reportKey(found->second.place(), "title", translatable("must be text"));
    reader.scenario().title = found->second.value->text;
}

/// Reports keys that belong to a file of the other format. False where there are none of its own, so that
/// what is missing need not be told.
bool checkKeysOfFormat(SectionReader& reader, const YamlEntries& file, int format) {
    const auto refuse = [&](std::span<const std::string_view> keys, const char* reason) {
        for (const std::string_view key : keys)
            if (const auto found = file.find(key); found != file.end())
                reader.problems().reportKey(found->second.key->offset, key, reason);
    };
    if (format == rodFormat)
        refuse(stringKeys,
               translatable("belongs to a drill string: a file that has it begins with `drillwave: 2`"));
    else
        refuse(rodKeys,
               translatable("belongs to a uniform rod: a file that has it begins with `drillwave: 1`; a "
                            "drill string has `string` instead of `rod`, and `hammer` or `pulse`"));
    const auto isThere = [&](std::string_view key) { return file.contains(key); };
    return !std::ranges::any_of(keysOf(format == rodFormat ? stringFormat : rodFormat), isThere) ||
           std::ranges::any_of(keysOf(format), isThere) || isThere("pulse");
}

constexpr const char* notBesideGroups =
    translatable("cannot be combined with `dimensionless`: give one or the other");

/// All that `bit_rock` may say there is the loading curve.
void readLawBesideGroups(SectionReader& reader, const YamlEntries& file) {
    const auto found = file.find("bit_rock");
    if (found == file.end()) return;
    const bool hasLaw = found->second.value->kind == YamlKind::map && found->second.value->valueOf(lawKey);
    if (!hasLaw) {
        reader.problems().reportKey(found->second.key->offset, "bit_rock", notBesideGroups);
        return;
    }
    const std::optional<YamlEntries> entries =
        reader.section(file, "bit_rock", "bit_rock", {lawKey, cornersKey});
    if (!entries) return;
    const bool isLawRead = readLaw(reader, *entries);
    for (const auto& [key, entry] : *entries) {
        const std::string path = joinedKey("bit_rock", key);
        if (key == lawKey || key == cornersKey) continue;
        const KeptParameter parameter = inFormOf(reader.scenario(), *findParameter(path));
        if (parameter->scope == Scope::withUnits)
            reader.problems().reportKey(entry.key->offset, path, notBesideGroups);
        else if (isLawRead)
            reader.readNumber(*parameter, entry);
    }
    if (!isLawRead) return;
    for (const Parameter& parameter : parameters())
        if (parameter.rules.law == reader.scenario().bitRock.law)
            reader.require(*entries, *inFormOf(reader.scenario(), parameter));
    readCorners(reader, *entries);
}

void readGroups(SectionReader& reader, const YamlEntries& file) {
    for (const std::string_view name : {"rod", "drill"})
        if (const auto found = file.find(name); found != file.end())
            reader.problems().reportKey(found->second.key->offset, name, notBesideGroups);
    readLawBesideGroups(reader, file);
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
                                    translatable("goes with a diameter, not with an area"));
}

void readBitRock(SectionReader& reader, const YamlEntries& file) {
    const std::optional<YamlEntries> entries =
        reader.section(file, "bit_rock", "bit_rock", {lawKey, cornersKey});
    if (!entries) return;
    const bool isLawRead = readLaw(reader, *entries);
    reader.readParameters(*entries, "bit_rock", isLawRead ? Applicability::checked : Applicability::ignored);
    reader.requireParameters(*entries, "bit_rock");
    if (isLawRead) readCorners(reader, *entries);
}

void readIndexing(SectionReader& reader, const YamlEntries& entries) {
    const auto found = entries.find(indexingKey);
    if (found == entries.end()) return;
    const YamlEntry& entry = found->second;
    reader.setPlace(rockIndexingKey, entry.place());
    if (const std::optional<RockIndexing> indexing = findRockIndexing(entry.value->text))
        reader.scenario().drill.indexing = *indexing;
    else
        reader.problems().reportValue(
            entry.place(), rockIndexingKey, entry.value->text,
            {translatable("must be one of %1"), {findWordParameter(rockIndexingKey)->list()}});
}

void readDrill(SectionReader& reader, const YamlEntries& file) {
    if (!file.contains("drill")) return;
    const std::optional<YamlEntries> entries = reader.section(file, "drill", "drill", {indexingKey});
    if (!entries) return;
    readIndexing(reader, *entries);
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
    if (problem.key.ends_with(".bore"))
        return read(problem.key) && read(problem.key.substr(0, problem.key.size() - 4) + "diameter");
    if (problem.key == "pulse.fall")
        return !reader.problems().concerns("pulse.rise") && !reader.problems().concerns("pulse.fall");
    if (problem.key.starts_with("bit_rock.corners.")) return read(problem.key);
    return problem.key == "pulse.points" && read("pulse.points") && !reader.problems().concerns("pulse.file");
}

/// Where a group comes from in a dimensional scenario.
std::string_view originOf(std::string_view key) {
    const KeptParameter parameter = findParameter(key);
    return parameter && parameter->isGroup() ? parameter->rules.rival : key;
}

void checkWhole(SectionReader& reader) {
    const bool clean = reader.problems().empty();
    for (InputProblem& problem : validate(reader.scenario())) {
        if (!clean && !isAboutTheFile(reader, problem)) continue;
        const std::optional<std::size_t> place =
            reader.placeOf(hasUnits(reader.scenario()) ? originOf(problem.key) : problem.key);
        reader.problems().reportAt(place.value_or(0), std::move(problem));
    }
}

ScenarioForm formOf(const YamlEntries& file, int format) {
    if (format == stringFormat) return ScenarioForm::string;
    return file.contains("dimensionless") ? ScenarioForm::dimensionless : ScenarioForm::dimensional;
}

/// True when all that is wrong is an unreadable table file.
bool readScenario(SectionReader& reader, const YamlNode& root, int format, const TableSource& tables,
                  DesignSetup& design) {
    std::vector<std::string_view> known(std::begin(commonKeys), std::end(commonKeys));
    known.insert(known.end(), keysOf(format).begin(), keysOf(format).end());
    // Those of the other format are told of as such where they stand.
    for (const std::string_view key : keysOf(format == rodFormat ? stringFormat : rodFormat))
        if (indexOf(root, key) < root.children.size()) known.push_back(key);
    const YamlEntries file = reader.entriesOf(root, "", known);
    reader.scenario().form = formOf(file, format);
    readTitle(reader, file);
    design = readDesignSetup(reader, file);
    if (!checkKeysOfFormat(reader, file, format)) return false;
    if (format == stringFormat) readDrillString(reader, file);
    if (reader.dimensional()) readRod(reader, file);
    if (hasUnits(reader.scenario())) {
        readBitRock(reader, file);
        readDrill(reader, file);
    } else {
        readGroups(reader, file);
    }
    const bool unreadable = isForced(reader.scenario()) && readPulse(reader, file, tables);
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
        return unreadableText(
            {"",
             {translatable("is not a text file: it holds %1"), {Message::ofTable(problem.reason)}},
             at.line,
             at.column});
    }
    const YamlTree tree = parseYaml(text);
    if (!tree.problem.text.isEmpty()) {
        const TextPosition at = positionOf(text, tree.problem.offset);
        ReadScenario result = unreadableText({"", tree.problem.text, at.line, at.column});
        result.unreadable = !tree.problem.isYaml;
        return result;
    }
    if (tree.root.kind == YamlKind::null)
        return unreadableText({"", translatable("the file is empty"), 1, 1});

    SectionReader reader(text);
    ReadScenario result;
    if (tree.root.kind != YamlKind::map)
        reader.problems().reportKey(
            tree.root.offset, "drillwave",
            translatable("the file must be lines of `key: value`, the first `drillwave: 1`"));
    else if (const std::optional<int> format = readFormat(reader, tree.root))
        result.unreadable = readScenario(reader, tree.root, *format, {source, tablePoints}, result.design);
    result.problems = reader.problems().take();
    result.scenario = std::move(reader.scenario());
    return result;
}

}  // namespace drillwave
