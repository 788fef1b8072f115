// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/result_scenario.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/archive/row_record.h"
#include "core/disk/file_bytes.h"
#include "core/model/blow_traits.h"
#include "core/model/section_pieces.h"
#include "core/report/blow_csv.h"
#include "core/report/report_html.h"
#include "core/report/result_remarks.h"
#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"
#include "core/text/text_input.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_reader.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

namespace {

using Node = YamlNode;

[[noreturn]] void refuseResult(const std::string& source, Message reason) {
    throw ScenarioError(ScenarioError::Kind::unreadable, source, {{"", std::move(reason)}});
}

bool endsWith(std::string_view path, std::string_view suffix) {
    if (path.size() < suffix.size()) return false;
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(path.substr(path.size() - suffix.size()), suffix, {}, lower);
}

[[noreturn]] void refuseResultValue(const std::string& source, std::string_view key, std::string_view value,
                                    const Message& reason) {
    throw ScenarioError(ScenarioError::Kind::invalid, source, {valueProblem(key, shortened(value), reason)});
}

/// What a result says of itself is how it is solved again: nothing of it is passed over.
void checkRecord(const Node& record, const std::string& source) {
    for (const std::string_view key :
         {rowRecordFormatKey, std::string_view("version"), std::string_view("method"),
          std::string_view("segments"), std::string_view("scenario")}) {
        int times = 0;
        for (std::size_t i = 0; i + 1 < record.children.size(); i += 2)
            times += record.children[i].text == key;
        if (times > 1)
            refuseResultValue(source, key, "",
                              {translatable("is given %1 times; keep one of them"), {std::to_string(times)}});
    }
    if (const std::string* format = record.textOf(rowRecordFormatKey);
        format && *format != std::to_string(rowRecordFormat))
        refuseResultValue(
            source, rowRecordFormatKey, *format,
            {translatable("this program reads the format %1"), {std::to_string(rowRecordFormat)}});
    if (const std::string* method = record.textOf("method"); method && *method != methodOfStrings)
        if (const Message problem = methodProblem(*method); !problem.isEmpty())
            refuseResultValue(source, "method", *method, problem);
    if (const std::string* segments = record.textOf("segments"))
        if (!segmentsIn(*segments)) refuseResultValue(source, "segments", *segments, segmentsProblem());
}

std::optional<MethodChoice> methodOf(const Node& record) {
    const std::string* given = record.textOf("method");
    const std::optional<Method> method = given ? findMethod(*given) : std::nullopt;
    if (!method) return std::nullopt;
    MethodChoice choice;
    choice.method = *method;
    if (const std::string* text = record.textOf("segments"))
        choice.lattice.segments = segmentsIn(*text).value_or(choice.lattice.segments);
    return choice;
}

/// JSON is YAML with braces: one reader does for both.
std::optional<ScenarioInput> parseRecord(std::string_view text, const std::string& source) {
    const YamlTree tree = parseYaml(text);
    const std::string* scenario = tree.problem.text.isEmpty() ? tree.root.textOf("scenario") : nullptr;
    if (!scenario) return std::nullopt;
    checkRecord(tree.root, source);
    const std::string* version = tree.root.textOf("version");
    return ScenarioInput{.document = parseScenario(*scenario, source),
                         .isResult = true,
                         .version = version ? *version : std::string(),
                         .method = methodOf(tree.root)};
}

/// A text with what tells its format.
struct InputText {
    std::string_view whole;
    std::string_view plain;  ///< without the byte order mark
    const std::string& source;
};

bool isPage(const InputText& input) {
    return input.plain.starts_with("<!DOCTYPE html") || endsWith(input.source, ".html");
}

std::optional<ScenarioInput> parsePage(const InputText& input) {
    if (std::optional<ScenarioInput> found = parseRecord(reportRecord(input.plain), input.source))
        return found;
    refuseResult(
        input.source,
        translatable(
            "is a web page and holds no scenario; only the HTML files of `drillwave report` begin with one"));
}

bool isCsv(const InputText& input) {
    return isCsvName(input.source) || input.plain.starts_with(csvRemarksBegin);
}

std::optional<ScenarioInput> parseCsv(const InputText& input) {
    const std::string yaml = scenarioFromHeader(input.plain);
    if (yaml.empty())
        refuseResult(
            input.source,
            translatable("ends in .csv and holds no scenario; only CSV files of run, gap, thrust and "
                         "accuracy do (for a sweep or table it is in the .yaml file beside it)"));
    const ResultRemarks remarks = remarksOf(yaml);
    if (!remarks.problem.isEmpty()) refuseResult(input.source, remarks.problem);
    return ScenarioInput{
        .document = parseScenario(std::string_view(yaml).substr(remarks.length), input.source),
        .isResult = true,
        .version = remarks.version,
        .method = remarks.method};
}

/// Whether a text looks like a record or JSON; a scenario may be in braces too.
bool mayBeRecord(const InputText& input) {
    const std::string_view text = input.plain;
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && text[first] == '{')
        return text.find("scenario") != std::string_view::npos;
    return text.starts_with(rowRecordKey) || text.find("\n" + std::string(rowRecordKey)) < 1000;
}

std::optional<ScenarioInput> parseRecordOfSize(const InputText& input) {
    if (input.whole.size() >= maximumInputBytes)
        refuseResult(input.source, translatable("is larger than 4 MiB, the limit for this kind of file"));
    return parseRecord(input.plain, input.source);
}

std::optional<ScenarioInput> refuseJson(const InputText& input) {
    refuseResult(input.source, translatable("ends in .json and holds no `scenario`; give the scenario file"));
}

std::optional<ScenarioInput> parseScenarioFile(const InputText& input) {
    if (input.whole.size() > maximumScenarioBytes)
        refuseResult(input.source,
                     translatable("the scenario file is larger than 1024 KiB, the limit for scenario files"));
    const ResultRemarks remarks = remarksOf(input.plain);
    if (!remarks.problem.isEmpty()) refuseResult(input.source, remarks.problem);
    return ScenarioInput{.document = parseScenario(input.whole, input.source),
                         .isResult = false,
                         .version = remarks.version,
                         .method = remarks.method};
}

/// A format of a file with a scenario. `read` throws ScenarioError where the text is of the format and holds
/// no scenario, and returns nothing where it can still be of a format below.
struct InputFormat {
    std::string_view name;
    bool (*recognises)(const InputText& input);
    std::optional<ScenarioInput> (*read)(const InputText& input);
};

/// All formats, in the order in which they are tried.
constexpr InputFormat inputFormats[] = {
    {"report in HTML", isPage, parsePage},
    {"CSV file", isCsv, parseCsv},
    {"record or JSON", mayBeRecord, parseRecordOfSize},
    {"JSON without a scenario", [](const InputText& input) { return endsWith(input.source, ".json"); },
     refuseJson},
    {"scenario file", [](const InputText&) { return true; }, parseScenarioFile},
};

/// The first version with outputs of version 2.
constexpr std::string_view versionOfOutputs2 = "0.3.0";

bool hasLosses(const Scenario& scenario) {
    return std::ranges::any_of(allSections(scenario.drillString), [](const Section* section) {
        return section->loss > 0 || section->attenuation > 0;
    });
}

/// Names the numbers that are others now, in the middle of a sentence.
Message changedNumbers(std::string_view version, const Scenario& scenario) {
    if (!isNewerVersion(versionOfOutputs2, version)) return {};
    std::vector<Message> changed;
    if (hasSections(scenario)) {
        changed.emplace_back(translatable("sequences of blows"));
        if (!hasUniformSections(scenario.drillString))
            changed.emplace_back(translatable("all results: cones are solved more exactly"));
        if (hasLosses(scenario))
            changed.emplace_back(translatable("cor and required feed: losses are counted"));
    }
    changed.emplace_back(translatable("contact shares"));
    changed.emplace_back(translatable("statements about the feed"));
    changed.emplace_back(translatable("energies, which are in J beside SI"));
    Message list;
    for (Message& each : changed) list = joined(std::move(list), "%1; %2", std::move(each));
    return list;
}

}  // namespace

bool isCsvName(std::string_view path) {
    return endsWith(path, ".csv");
}

ScenarioInput parseInput(std::string_view text, const std::string& source) {
    const InputText input{text, text.substr(byteOrderMarkLength(text)), source};
    std::optional<ScenarioInput> found;
    for (const InputFormat& format : inputFormats)
        if (format.recognises(input) && (found = format.read(input))) break;
    assert(found);  // the last format takes every text
    return *std::move(found);
}

ScenarioInput loadInput(const std::string& path) {
    const FileBytes file = readStart(path, maximumInputBytes);
    if (!file.problem.isEmpty()) refuseResult(path, {translatable("the scenario file %1"), {file.problem}});
    return parseInput(file.bytes, path);
}

ScenarioDocument loadResultScenario(const std::string& path) {
    ScenarioInput input = loadInput(path);
    if (!input.isResult) refuseResult(path, translatable("holds no scenario of a result"));
    return std::move(input.document);
}

bool isNewerVersion(std::string_view version, std::string_view than) {
    using Numbers = std::array<int, 4>;  // "0.2.0+203.ga059c129", the last 0 where it is missing
    const auto numbersOf = [](std::string_view text) -> std::optional<Numbers> {
        Numbers numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto read = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
            if (read.ec != std::errc()) return i == 3 ? std::optional(numbers) : std::nullopt;
            text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
            if (text.starts_with(i == 2 ? '+' : '.')) text.remove_prefix(1);
        }
        return numbers;
    };
    const std::optional<Numbers> one = numbersOf(version), other = numbersOf(than);
    return one && other && *one > *other;
}

std::string completeScenarioText(ScenarioDocument document) {
    const std::string table = std::exchange(document.scenario.pulse.tableFile, {});
    std::string text;
    try {
        text = writeScenario(document);
    } catch (const ScenarioError&) {
        if (table.empty()) throw;
        const std::filesystem::path folder = std::filesystem::path(document.source).parent_path();
        document.scenario.pulse.tableFile = std::filesystem::absolute(folder / table).string();
        text = writeScenario(document);
    }
    // Of a result that was made a file: a new result says for itself what it is.
    return text.substr(remarksLength(text));
}

Message changesSentence(std::string_view version, const Scenario& scenario) {
    Message changed = changedNumbers(version, scenario);
    if (changed.isEmpty()) return {};
    return {translatable(
                "Written by Drillwave %1. Since then these results have changed: %2 (manual, Upgrading)."),
            {shortened(std::string(version)), std::move(changed)}};
}

}  // namespace drillwave
