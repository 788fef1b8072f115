// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scenario_argument.h"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/preset_options.h"
#include "app/signal_options.h"
#include "core/archive/result_scenario.h"
#include "core/model/alerts.h"
#include "core/model/assignments.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_words.h"
#include "core/model/validation.h"
#include "core/model/version.h"
#include "core/report/alert_words.h"
#include "core/study/design/design_texts.h"
#include "core/text/decimal_text.h"
#include "core/text/message.h"
#include "core/text/name_text.h"
#include "core/text/text_input.h"
#include "core/yaml/examples.h"

namespace drillwave {

namespace {

struct Setting {
    std::string key;
    std::string value;
    std::string word;  ///< as quoted: "--set drill.blows=50", "--blows 50"
    bool isShort = false;
};

/// Refuses two settings of which one would silently undo the other.
[[noreturn]] void refusePair(const std::string& one, const std::string& other, const Message& problem) {
    throw CommandError(ExitCode::usage,
                       Message(translatable("%1 and %2 %3; give one of them"), {one, other, problem}));
}

Assignments assignmentsOf(const std::vector<Setting>& settings) {
    Assignments assignments;
    for (const Setting& setting : settings) assignments.add(setting.key);
    return assignments;
}

/// Returns the settings in the order in which the scenario takes them.
std::vector<Setting> settings(const Arguments& arguments) {
    std::vector<Setting> all;
    for (const std::string& word : arguments.values(setOption.name)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw CommandError(ExitCode::usage,
                               about("--set " + shortened(word), translatable("needs KEY=VALUE")));
        all.push_back({std::string(trimmed(word.substr(0, equals))), word.substr(equals + 1),
                       "--set " + shortened(word)});
    }
    for (const auto& [key, option] : arguments.shorts()) {
        const std::string value = arguments.value(option).value();
        all.push_back(
            {std::string(key), value, OptionSpec{option, {}, {}}.text() + " " + shortened(value), true});
    }
    const Assignments assignments = assignmentsOf(all);
    if (const auto pair = assignments.rivals())
        refusePair(all[pair->one].word, all[pair->other].word, pair->problem);
    std::vector<Setting> inOrder;
    for (const std::size_t i : assignments.order()) inOrder.push_back(std::move(all[i]));
    return inOrder;
}

constexpr std::string_view titleKey = "title";

bool isKey(const std::string& key) {
    return findWordParameter(key) || key == restrikeKey || key == titleKey || findParameter(key);
}

/// Why not, empty when it is set.
Message assign(Scenario& scenario, const Setting& setting) {
    if (setting.key != titleKey) return assignText(scenario, setting.key, setting.value);
    if (const TextProblem problem = checkText(setting.value); !problem.reason.empty())
        return {translatable("holds %1"), {Message::ofTable(problem.reason)}};
    scenario.title = setting.value;
    return {};
}

/// Returns the built-in example that FILE names; a file of that name goes first.
const Example* exampleNamed(const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error) ? nullptr : findExample(path);
}

/// "`a` or `b`" where FILE is nearly the name of an example, or how those of a few begin.
Message nearExample(const std::string& path) {
    std::vector<std::string_view> names, begun;
    for (const Example& example : builtInExamples()) {
        names.push_back(example.name);
        if (!path.empty() && names.back().starts_with(path)) begun.push_back(names.back());
    }
    constexpr std::size_t few = 3;
    if (begun.empty() || begun.size() > few) begun = {nearestName(path, names)};
    if (begun.front().empty()) return {};
    Message list;
    for (const std::string_view name : begun)
        list = joined(std::move(list), translatable("%1 or %2"), "`" + std::string(name) + "`");
    return list;
}

void tellNewerVersion(const std::string& path, const std::string& version, const ReadingStyle& style) {
    if (isNewerVersion(version, versionText))
        printRemark(
            {translatable("%1: note: written by Drillwave %2, newer than this %3: results may differ"),
             {path, shortened(version), std::string(versionText)}},
            style);
}

void tellOlderVersion(const std::string& path, const ScenarioInput& input, const ReadingStyle& style) {
    if (Message changes = changesSentence(input.version, input.document.scenario); !changes.isEmpty())
        printRemark({translatable("%1: note: %2"), {path, std::move(changes)}}, style);
}

}  // namespace

void printRemark(const Message& remark, const ReadingStyle& style) {
    std::fprintf(stderr, "%s\n", printable(style.said(remark)).c_str());
}

std::vector<OptionSpec> scenarioOptions(const std::vector<OptionSpec>& own) {
    std::vector<OptionSpec> options{setOption};
    for (const OptionSpec& option : presetOptionSpecs()) options.push_back(option);
    options.insert(options.end(), own.begin(), own.end());
    for (const OptionSpec& option : recordOptionSpecs()) options.push_back(option);
    return options;
}

void rethrow(const ScenarioError& error) {
    const bool unreadable = error.kind() == ScenarioError::Kind::unreadable;
    throw CommandError(unreadable ? ExitCode::unreadableInput : ExitCode::invalidScenario, error.messages());
}

std::string inputBytes(const std::string& path, const ReadingStyle& style) {
    if (const Example* example = exampleNamed(path)) return std::string(example->text);
    FileBytes file = readInput(path, maximumInputBytes, style);
    if (file.problem.isEmpty()) return std::move(file.bytes);
    Message problem{translatable("the scenario file %1"), {file.problem}};
    if (const Message near = nearExample(path); !near.isEmpty())
        problem = {translatable("%1; did you mean the example %2?"), {problem, near}};
    throw CommandError(ExitCode::unreadableInput, std::vector{about(inputName(path), problem)});
}

ScenarioInput parsedInput(std::string_view bytes, const std::string& path) {
    try {
        return parseInput(bytes, inputName(path));
    } catch (const ScenarioError& error) {
        rethrow(error);
    }
}

ScenarioInput loadScenarioFile(const std::string& path, const ReadingStyle& style) {
    return parsedInput(inputBytes(path, style), path);
}

void checkNotInputFile(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code error;
        if (std::filesystem::equivalent(output, input, error) && !error)
            throw CommandError(
                ExitCode::usage,
                Message(translatable("-o %1 is also the input (%2); choose another name for the output"),
                        {output, input}));
    }
}

std::vector<std::string> inputsOf(const Arguments& arguments, const ScenarioDocument& document) {
    std::vector<std::string> inputs = arguments.operands();
    for (const std::string_view option : inputOptions)
        for (std::string& file : arguments.values(option)) inputs.push_back(std::move(file));
    if (const std::string& table = document.scenario.pulse.tableFile; !table.empty())
        inputs.push_back((std::filesystem::path(inputs.front()).parent_path() / table).string());
    return inputs;
}

void checkOutputIsNoInput(const std::string& output, const Arguments& arguments,
                          const ScenarioDocument& document) {
    checkNotInputFile(output, inputsOf(arguments, document));
}

namespace {

/// Tells that a number of one place of a string is that of all sections of its repeat.
void remarkOnRepeat(std::string_view key, const Scenario& scenario, const ReadingStyle& style) {
    const KeptParameter parameter = findParameter(key);
    if (!parameter || !parameter->address || parameter->address->chain != SectionAddress::Chain::string)
        return;
    const std::vector<const Section*> sections = expandedSections(scenario.drillString);
    const std::size_t place = parameter->address->place;
    if (place < 1 || place > sections.size() || std::ranges::count(sections, sections[place - 1]) < 2) return;
    printRemark({translatable("note: %1 sets %2, which is one section with a repeat; to set only one of "
                              "them, write the sections "
                              "out in FILE without the repeat"),
                 {std::string(key), addressedWords(*parameter->address, scenario.drillString)}},
                style);
}

}  // namespace

ScenarioInput loadScenarioInput(const std::string& path, const Arguments& arguments) {
    if (isStandardInput(path) && arguments.value("presets") == "-")
        throw CommandError(ExitCode::usage,
                           translatable("FILE - and --presets - would both read standard input; take one"));
    ScenarioInput input = loadScenarioFile(path, arguments.style());
    tellNewerVersion(inputName(path), input.version, arguments.style());
    tellOlderVersion(inputName(path), input, arguments.style());
    Scenario& scenario = input.document.scenario;
    std::vector<std::string> choices = arguments.values("choose");
    std::ranges::copy(input.document.design.choose, std::back_inserter(choices));
    std::ranges::copy(arguments.values("vary"), std::back_inserter(choices));
    applyPresets(scenario, arguments, inputName(path), std::ranges::any_of(choices, choosesPresets));
    applySignal(input.document, arguments, inputName(path));
    std::vector<Message> problems;
    bool isUsage = false;
    const std::vector<Setting> all = settings(arguments);
    for (const Setting& setting : all) {
        const Message problem = assign(scenario, setting);
        if (problem.isEmpty()) continue;
        problems.push_back(about(setting.word, problem));
        isUsage |= setting.isShort || !isKey(setting.key);
    }
    if (!problems.empty())
        throw CommandError(isUsage ? ExitCode::usage : ExitCode::invalidScenario, problems,
                           CommandError::Begin::withOption);
    if (const auto pair = assignmentsOf(all).meeting(scenario))
        refusePair(all[pair->one].word, all[pair->other].word, pair->problem);
    const char* pattern = arguments.has(setOption.name) ? translatable("%1 with --set: %2") : "%1: %2";
    for (const InputProblem& problem : validate(scenario))
        problems.emplace_back(pattern, std::vector<Message>{inputName(path), problem.text});
    if (!problems.empty())
        throw CommandError(ExitCode::invalidScenario, problems, CommandError::Begin::withOption);
    for (const Setting& setting : all) remarkOnRepeat(setting.key, scenario, arguments.style());
    return input;
}

ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments) {
    ScenarioInput input = loadScenarioInput(path, arguments);
    if (input.method && input.method->method != Method::exact)
        printRemark({translatable("%1: note: was solved by %2; this command solves exactly"),
                     {inputName(path), methodMessage(*input.method)}},
                    arguments.style());
    return std::move(input.document);
}

void checkNotSet(const Arguments& arguments, const Scenario& scenario, std::span<const SweepAxis> axes,
                 std::span<const std::string> words) {
    assert(axes.size() == words.size());
    for (const SweepAxis& axis : axes)
        if (!axis.presets) remarkOnRepeat(axis.key(), scenario, arguments.style());
    // The places of a string that an axis names are counted with the repeats of the point.
    std::vector<Scenario> repeated{scenario};
    for (const SweepAxis& axis : axes) {
        if (axis.key() != "string.repeat" || !axis.parameter->applies(scenario)) continue;
        for (std::uint64_t i = 0; i < std::min<std::uint64_t>(axis.count, maximumSections); ++i)
            axis.assign(repeated.emplace_back(scenario), axis.value(i));
    }
    const auto keysOf = [](const SweepAxis& axis) {
        return axis.presets ? axis.presets->keys() : std::vector<std::string_view>{axis.key()};
    };
    for (const Setting& setting : settings(arguments))
        for (std::size_t a = 0; a < axes.size(); ++a)
            for (const std::string_view key : keysOf(axes[a]))
                for (const Scenario& there : repeated)
                    if (const Message problem = rivalProblem(setting.key, scenario, key, there);
                        !problem.isEmpty())
                        refusePair(words[a], setting.word, problem);
}

void remarkOnValues(const Scenario& scenario, const std::string& path, const ReadingStyle& style) {
    for (const Alert& alert : alertsFor(scenario))
        if (alert.code == AlertCode::implausibleValue)
            printRemark({translatable("%1: warning: %2"), {inputName(path), alertMessage(alert, style)}},
                        style);
}

}  // namespace drillwave
