#include "app/scenario_argument.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command_error.h"
#include "core/file/result_scenario.h"
#include "core/model/decimal_text.h"
#include "core/model/parameter.h"
#include "core/model/rival_keys.h"
#include "core/model/validation.h"

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
void checkRivals(const std::vector<Setting>& all) {
    for (auto later = all.begin(); later != all.end(); ++later)
        for (auto earlier = all.begin(); earlier != later; ++earlier)
            if (areRivals(earlier->key, later->key))
                throw CommandError(ExitCode::usage, quoted(*earlier) + " and " + quoted(*later) +
                                                        " set the same thing; give one of them");
}

std::vector<Setting> settings(const Arguments& arguments) {
    std::vector<Setting> all;
    for (const std::string& word : arguments.values(setOption.name)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw CommandError(ExitCode::usage, "--set " + shortened(word) + ": needs KEY=VALUE");
        all.push_back({std::string(trimmed(word.substr(0, equals))), word.substr(equals + 1), word});
    }
    checkRivals(all);
    // The shape is not in the table of parameters: its null pointer comes first. Groups are last in the
    // table.
    std::ranges::stable_sort(all, {}, [](const Setting& s) { return findParameter(s.key); });
    return all;
}

bool isKey(const std::string& key) {
    return key == "pulse.shape" || findParameter(key);
}

}  // namespace

ScenarioDocument loadScenarioFile(const std::string& path) {
    try {
        return loadScenarioOrResult(path);
    } catch (const ScenarioError& error) {
        const bool unreadable = error.kind() == ScenarioError::Kind::unreadable;
        throw CommandError(unreadable ? ExitCode::unreadableInput : ExitCode::invalidScenario, error.lines());
    }
}

void checkOutputIsNoInput(const std::string& output, const std::string& scenarioPath,
                          const ScenarioDocument& document, const std::vector<std::string>& others) {
    std::vector<std::string> inputs{scenarioPath};
    inputs.insert(inputs.end(), others.begin(), others.end());
    if (const std::string& table = document.scenario.pulse.tableFile; !table.empty())
        inputs.push_back((std::filesystem::path(scenarioPath).parent_path() / table).string());
    for (const std::string& input : inputs) {
        std::error_code error;
        if (std::filesystem::equivalent(output, input, error) && !error)
            throw CommandError(ExitCode::usage, "-o " + output + " is read as input (" + input +
                                                    "); choose another name for the output");
    }
}

ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments) {
    ScenarioDocument document = loadScenarioFile(path);
    std::vector<std::string> problems;
    bool unknownKey = false;
    for (const Setting& setting : settings(arguments)) {
        const std::string problem = assignText(document.scenario, setting.key, setting.value);
        if (problem.empty()) continue;
        problems.push_back(quoted(setting) + ": " + problem);
        unknownKey |= !isKey(setting.key);
    }
    if (!problems.empty())
        throw CommandError(unknownKey ? ExitCode::usage : ExitCode::invalidScenario, problems,
                           CommandError::Begin::withOption);
    for (const Problem& problem : validate(document.scenario))
        problems.push_back(path + " with --set: " + problem.text);
    if (!problems.empty()) throw CommandError(ExitCode::invalidScenario, problems);
    return document;
}

void checkNotSet(const Arguments& arguments, std::string_view key, const std::string& what) {
    for (const Setting& setting : settings(arguments))
        if (areRivals(setting.key, key))
            throw CommandError(ExitCode::usage,
                               what + " and " + quoted(setting) + " set the same thing; give one of them");
}

void remarkOnValues(const Scenario& scenario, const std::string& path) {
    for (const Alert& alert : alertsFor(scenario))
        if (alert.code == implausibleValue)
            std::fprintf(stderr, "%s: warning: %s\n", path.c_str(), alert.text.c_str());
}

}  // namespace drillwave
