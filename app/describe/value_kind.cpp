// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/describe/value_kind.h"

#include <algorithm>
#include <span>

#include "app/help_topic.h"
#include "core/archive/result_files.h"
#include "core/blow/method.h"
#include "core/blow/outputs.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/preset.h"
#include "core/model/section_field.h"
#include "core/report/report_studies.h"
#include "core/study/design/statistic.h"
#include "core/text/enum_names.h"
#include "core/text/languages.h"
#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

namespace {

constexpr EnumNames<ValueKind> kindNames{
    {{ValueKind::free, "free"},       {ValueKind::folder, "folder"},
     {ValueKind::file, "file"},       {ValueKind::scenario, "scenario"},
     {ValueKind::example, "example"}, {ValueKind::parameter, "parameter"},
     {ValueKind::choice, "choice"},   {ValueKind::aim, "aim"},
     {ValueKind::limit, "limit"},     {ValueKind::statistic, "statistic"},
     {ValueKind::output, "output"},   {ValueKind::outputs, "outputs"},
     {ValueKind::formats, "formats"}, {ValueKind::reportStudies, "report_studies"},
     {ValueKind::method, "method"},   {ValueKind::language, "language"},
     {ValueKind::rod, "rod"},         {ValueKind::hammer, "hammer"},
     {ValueKind::rock, "rock"},       {ValueKind::topic, "topic"}}};

/// Options with a kind by their name, because the placeholder of their value says less.
struct NamedKind {
    std::string_view option;
    ValueKind kind;
};
constexpr NamedKind namedKinds[]{{"outputs", ValueKind::outputs}, {"output", ValueKind::output},
                                 {"plots", ValueKind::formats},   {"with", ValueKind::reportStudies},
                                 {"method", ValueKind::method},   {"language", ValueKind::language},
                                 {"rod", ValueKind::rod},         {"hammer", ValueKind::hammer},
                                 {"rock", ValueKind::rock},       {"choose", ValueKind::choice}};

/// "string.rod.length" and "hammer.1.length", with the names that the built-in strings give to sections.
std::vector<std::string> sectionKeys() {
    std::vector<std::string> owners{"hammer.1"};
    for (const Example& example : builtInExamples()) {
        if (!example.ofString) continue;
        const ScenarioDocument document = parseScenario(example.text, example.name);
        for (const StringPart& part : document.scenario.drillString.parts)
            for (const Section& section : part.sections) {
                const std::string owner = "string." + section.name;
                const bool isWord = !section.name.empty() && owner.find(' ') == std::string::npos;
                if (isWord && std::ranges::find(owners, owner) == owners.end()) owners.push_back(owner);
            }
    }
    std::vector<std::string> keys{"string.repeat"};
    for (const std::string& owner : owners)
        for (const SectionField& field : sectionFields())
            keys.push_back(owner + "." + std::string(field.key));
    return keys;
}

std::vector<std::string> parameterWords() {
    std::vector<std::string> words;
    for (const std::string& key : parameterNames()) {
        words.push_back(key + "=");
        if (key == restrikeKey)
            for (const char* value : {"true", "false"}) words.push_back(key + "=" + value);
        if (const WordParameter* word = findWordParameter(key))
            for (const std::string_view value : word->words())
                words.push_back(key + "=" + std::string(value));
    }
    for (const std::string& key : sectionKeys()) words.push_back(key + "=");
    return words;
}

std::vector<std::string> outputWords() {
    std::vector<std::string> words;
    for (const std::span<const Output> table : {outputs(), drillOutputs()})
        for (const Output& output : table) words.emplace_back(output.name);
    return words;
}

std::vector<std::string> statisticWords() {
    std::vector<std::string> words{Statistic{Statistic::Kind::nominal}.name()};
    for (const Statistic& statistic : customaryStatistics()) words.push_back(statistic.name());
    return words;
}

/// Returns the outputs with words around them: "max:efficiency@" after "max:".
std::vector<std::string> outputsBetween(std::string_view before, std::string_view behind) {
    std::vector<std::string> words = outputWords();
    for (std::string& word : words) word = std::string(before) + word + std::string(behind);
    return words;
}

std::vector<std::string> aimWords() {
    std::vector<std::string> words = outputsBetween("max:", "@");
    for (const std::string& word : outputsBetween("min:", "@")) words.push_back(word);
    return words;
}

std::vector<std::string> exampleWords() {
    std::vector<std::string> words;
    for (const Example& example : builtInExamples()) words.push_back(example.name);
    return words;
}

std::vector<std::string> languageWords() {
    std::vector<std::string> words;
    for (const Language& language : languages) words.emplace_back(language.code);
    return words;
}

std::vector<std::string> presetWords(PresetKind kind) {
    std::vector<std::string> words;
    for (const Preset& preset : builtInPresets())
        if (preset.kind == kind) words.push_back(preset.name);
    return words;
}

/// Keys, and the presets of hammers, rods and bits, each once.
std::vector<std::string> choiceWords() {
    std::vector<std::string> words = parameterWords();
    const auto add = [&](PresetPart part, const std::string& presetName) {
        std::string word = std::string(name(part)) + "=" + presetName;
        if (std::ranges::find(words, word) == words.end()) words.push_back(std::move(word));
    };
    for (const std::string& preset : presetWords(PresetKind::hammer)) add(PresetPart::hammer, preset);
    for (const SectionPreset& preset : builtInSectionPresets())
        if (preset.kind == SectionPresetKind::piston) add(PresetPart::hammer, preset.name);
    for (const std::string& preset : presetWords(PresetKind::rod)) add(PresetPart::rod, preset);
    for (const SectionPreset& preset : builtInSectionPresets())
        if (preset.kind == SectionPresetKind::bit) add(PresetPart::bit, preset.name);
    return words;
}

}  // namespace

std::string_view name(ValueKind kind) {
    return kindNames[kind];
}

ValueKind valueKind(const OptionSpec& option) {
    const auto named = std::ranges::find(namedKinds, option.name, &NamedKind::option);
    if (named != std::end(namedKinds)) return named->kind;
    if (option.value.starts_with("KEY=")) return ValueKind::parameter;
    if (option.value.starts_with("max:")) return ValueKind::aim;
    if (option.value.starts_with("OUTPUT@")) return ValueKind::limit;
    if (option.value == "DIR") return ValueKind::folder;
    return option.value.find("FILE") == std::string_view::npos ? ValueKind::free : ValueKind::file;
}

ValueKind operandKind(const Command& command) {
    if (command.mostOperands == 0) return ValueKind::free;
    if (command.operands.starts_with("[NAME]")) return ValueKind::example;
    return command.operands.starts_with("FILE") ? ValueKind::scenario : ValueKind::file;
}

bool isStaged(ValueKind kind) {
    return kind == ValueKind::parameter || kind == ValueKind::choice || kind == ValueKind::aim ||
           kind == ValueKind::limit;
}

bool isList(ValueKind kind) {
    return kind == ValueKind::outputs || kind == ValueKind::formats || kind == ValueKind::reportStudies;
}

std::vector<std::string> wordsOf(ValueKind kind) {
    switch (kind) {
        case ValueKind::scenario:
        case ValueKind::example:
            return exampleWords();
        case ValueKind::parameter:
            return parameterWords();
        case ValueKind::choice:
            return choiceWords();
        case ValueKind::aim:
            return aimWords();
        case ValueKind::limit:
            return outputsBetween({}, "@");
        case ValueKind::statistic:
            return statisticWords();
        case ValueKind::output:
        case ValueKind::outputs:
            return outputWords();
        case ValueKind::formats:
            return {pictureFormats.begin(), pictureFormats.end()};
        case ValueKind::reportStudies:
            return {reportStudyNames.begin(), reportStudyNames.end()};
        case ValueKind::method:
            return {methodNames().begin(), methodNames().end()};
        case ValueKind::language:
            return languageWords();
        case ValueKind::rod:
            return presetWords(PresetKind::rod);
        case ValueKind::hammer:
            return presetWords(PresetKind::hammer);
        case ValueKind::rock:
            return presetWords(PresetKind::rock);
        case ValueKind::topic:
            return topicNames();
        case ValueKind::free:
        case ValueKind::folder:
        case ValueKind::file:
            return {};
    }
    return {};
}

}  // namespace drillwave
