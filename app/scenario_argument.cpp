// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scenario_argument.h"

#include <cstdio>
#include <filesystem>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/preset_options.h"
#include "core/file/examples.h"
#include "core/model/alerts.h"
#include "core/model/assignments.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_parameter.h"
#include "core/model/validation.h"
#include "core/model/version.h"
#include "core/report/alert_words.h"
#include "core/text/decimal_text.h"
#include "core/text/nearest_name.h"

namespace drillwave {

namespace {

struct Setting {
    std::string key;
    std::string value;
    std::string word;
};

std::string quoted(const Setting& setting) {
    return "--set " + shortened(setting.word);
}

/// One setting would silently undo the other.
void checkRivals(const std::vector<Setting>& all, const Assignments& assignments) {
    for (std::size_t later = 0; later < all.size(); ++later)
        for (std::size_t earlier = 0; earlier < later; ++earlier)
            if (assignments.contradict(earlier, later))
                throw CommandError(ExitCode::usage, quoted(all[earlier]) + " and " + quoted(all[later]) +
                                                        " set the same thing; give one of them");
}

/// Two places of a repeat are one section of the file.
void checkPlaces(const std::vector<Setting>& all, const Scenario& scenario) {
    for (std::size_t later = 0; later < all.size(); ++later)
        for (std::size_t earlier = 0; earlier < later; ++earlier) {
            const Parameter* one = findParameter(all[earlier].key);
            const Parameter* other = findParameter(all[later].key);
            if (one && other && meetInOneSection(*one, *other, scenario))
                throw CommandError(ExitCode::usage,
                                   quoted(all[earlier]) + " and " + quoted(all[later]) +
                                       " set the same section, which a repeat brings to both "
                                       "places; give one of them");
        }
}

/// In the order in which the scenario takes them.
std::vector<Setting> settings(const Arguments& arguments) {
    std::vector<Setting> all;
    for (const std::string& word : arguments.values(setOption.name)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw CommandError(ExitCode::usage, "--set " + shortened(word) + ": needs KEY=VALUE");
        all.push_back({std::string(trimmed(word.substr(0, equals))), word.substr(equals + 1), word});
    }
    Assignments assignments;
    for (const Setting& setting : all) assignments.add(setting.key);
    checkRivals(all, assignments);
    std::vector<Setting> inOrder;
    for (const std::size_t i : assignments.order()) inOrder.push_back(std::move(all[i]));
    return inOrder;
}

constexpr std::string_view titleKey = "title";

bool isKey(const std::string& key) {
    return key == pulseShapeKey || key == restrikeKey || key == titleKey || findParameter(key);
}

/// Why not, empty when it is set.
std::string assign(Scenario& scenario, const Setting& setting) {
    if (setting.key != titleKey) return assignText(scenario, setting.key, setting.value);
    if (const TextProblem problem = checkText(setting.value); !problem.reason.empty())
        return "holds " + problem.reason;
    scenario.title = setting.value;
    return {};
}

/// The built-in example that FILE names; a file of that name goes first.
const Example* exampleNamed(const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error) ? nullptr : findExample(path);
}

/// "; did you mean …?" where FILE is nearly the name of an example, or how those of a few begin.
std::string nearExample(const std::string& path) {
    std::vector<std::string_view> names, begun;
    for (const Example& example : builtInExamples()) {
        names.push_back(example.name);
        if (!path.empty() && names.back().starts_with(path)) begun.push_back(names.back());
    }
    constexpr std::size_t few = 3;
    if (begun.empty() || begun.size() > few) begun = {nearestName(path, names)};
    if (begun.front().empty()) return {};
    std::string list;
    for (const std::string_view name : begun)
        list += (list.empty() ? "`" : " or `") + std::string(name) + "`";
    return "; did you mean the example " + list + "?";
}

void tellNewerVersion(const std::string& path, const std::string& version) {
    if (isNewerVersion(version, versionText))
        std::fprintf(stderr, "%s: note: written by Drillwave %s, newer than this %s: results may differ\n",
                     path.c_str(), shortened(version).c_str(), versionText);
}

}  // namespace

std::vector<OptionSpec> scenarioOptions(std::initializer_list<OptionSpec> own) {
    std::vector<OptionSpec> options{setOption};
    for (const OptionSpec& option : presetOptionSpecs()) options.push_back(option);
    options.insert(options.end(), own);
    return options;
}

void rethrow(const ScenarioError& error) {
    const bool unreadable = error.kind() == ScenarioError::Kind::unreadable;
    throw CommandError(unreadable ? ExitCode::unreadableInput : ExitCode::invalidScenario, error.lines());
}

std::string inputBytes(const std::string& path) {
    if (const Example* example = exampleNamed(path)) return std::string(example->text);
    FileBytes file = readInput(path, maximumInputBytes);
    if (!file.problem.empty())
        throw CommandError(ExitCode::unreadableInput, std::vector{inputName(path) + ": the scenario file " +
                                                                  file.problem + nearExample(path)});
    return std::move(file.bytes);
}

ScenarioInput parsedInput(std::string_view bytes, const std::string& path) {
    try {
        return parseInput(bytes, inputName(path));
    } catch (const ScenarioError& error) {
        rethrow(error);
    }
}

ScenarioInput loadScenarioFile(const std::string& path) {
    return parsedInput(inputBytes(path), path);
}

void checkOutputIsNone(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code error;
        if (std::filesystem::equivalent(output, input, error) && !error)
            throw CommandError(ExitCode::usage, "-o " + output + " is read as input (" + input +
                                                    "); choose another name for the output");
    }
}

void checkOutputIsNoInput(const std::string& output, const std::string& scenarioPath,
                          const ScenarioDocument& document, const std::vector<std::string>& others) {
    std::vector<std::string> inputs{scenarioPath};
    inputs.insert(inputs.end(), others.begin(), others.end());
    if (const std::string& table = document.scenario.pulse.tableFile; !table.empty())
        inputs.push_back((std::filesystem::path(scenarioPath).parent_path() / table).string());
    checkOutputIsNone(output, inputs);
}

ScenarioInput loadScenarioInput(const std::string& path, const Arguments& arguments,
                                DrillStrings drillStrings) {
    if (isStandardInput(path) && arguments.value("presets") == "-")
        throw CommandError(ExitCode::usage,
                           "FILE - and --presets - would both read standard input; take one");
    ScenarioInput input = loadScenarioFile(path);
    tellNewerVersion(inputName(path), input.version);
    Scenario& scenario = input.document.scenario;
    if (isString(scenario) && drillStrings == DrillStrings::refused)
        throw CommandError(ExitCode::invalidScenario,
                           inputName(path) +
                               ": is a drill string, and this command solves uniform rods alone (`drillwave: "
                               "1`); `drillwave "
                               "curve FILE --along bit_rock.gap=0mm:2mm` follows a string along its gap");
    applyPresets(scenario, arguments, inputName(path));
    std::vector<std::string> problems;
    bool unknownKey = false;
    const std::vector<Setting> all = settings(arguments);
    for (const Setting& setting : all) {
        const std::string problem = assign(scenario, setting);
        if (problem.empty()) continue;
        problems.push_back(quoted(setting) + ": " + problem);
        unknownKey |= !isKey(setting.key);
    }
    if (!problems.empty())
        throw CommandError(unknownKey ? ExitCode::usage : ExitCode::invalidScenario, problems,
                           CommandError::Begin::withOption);
    checkPlaces(all, scenario);
    for (const InputProblem& problem : validate(scenario))
        problems.push_back(inputName(path) + " with --set: " + problem.text);
    if (!problems.empty())
        throw CommandError(ExitCode::invalidScenario, problems, CommandError::Begin::withOption);
    return input;
}

ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments,
                                      DrillStrings drillStrings) {
    ScenarioInput input = loadScenarioInput(path, arguments, drillStrings);
    if (input.method && input.method->method != Method::exact)
        std::fprintf(stderr, "%s: note: was solved by %s; this command solves exactly\n",
                     inputName(path).c_str(), describe(*input.method).c_str());
    return std::move(input.document);
}

void checkNotSet(const Arguments& arguments, std::string_view key, const std::string& what) {
    for (const Setting& setting : settings(arguments))
        if (areRivals(setting.key, key))
            throw CommandError(ExitCode::usage,
                               what + " and " + quoted(setting) + " set the same thing; give one of them");
}

void remarkOnValues(const Scenario& scenario, const std::string& path) {
    for (const Alert& alert : alertsFor(scenario))
        if (alert.code == AlertCode::implausibleValue)
            std::fprintf(stderr, "%s: warning: %s\n", inputName(path).c_str(), alertText(alert).c_str());
}

}  // namespace drillwave
