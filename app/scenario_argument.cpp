#include "app/scenario_argument.h"

#include <algorithm>

#include "app/command_error.h"
#include "core/file/result_scenario.h"
#include "core/model/decimal_text.h"
#include "core/model/parameter.h"
#include "core/model/validation.h"

namespace drillwave {

namespace {

struct Setting {
    std::string key;
    std::string value;
    std::string word;
};

std::vector<Setting> settings(const Arguments& arguments) {
    std::vector<Setting> all;
    for (const std::string& word : arguments.values(setOption.name)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw CommandError(ExitCode::usage, "--set " + shortened(word) + ": needs KEY=VALUE");
        all.push_back({std::string(trimmed(word.substr(0, equals))), word.substr(equals + 1), word});
    }
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

ScenarioDocument loadScenarioArgument(const std::string& path, const Arguments& arguments) {
    ScenarioDocument document = loadScenarioFile(path);
    std::vector<std::string> problems;
    bool unknownKey = false;
    for (const Setting& setting : settings(arguments)) {
        const std::string problem = assignText(document.scenario, setting.key, setting.value);
        if (problem.empty()) continue;
        problems.push_back("--set " + shortened(setting.word) + ": " + problem);
        unknownKey |= !isKey(setting.key);
    }
    if (!problems.empty())
        throw CommandError(unknownKey ? ExitCode::usage : ExitCode::invalidScenario, problems);
    for (const Problem& problem : validate(document.scenario))
        problems.push_back(path + " with --set: " + problem.text);
    if (!problems.empty()) throw CommandError(ExitCode::invalidScenario, problems);
    return document;
}

}  // namespace drillwave
