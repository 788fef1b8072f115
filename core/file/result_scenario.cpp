#include "core/file/result_scenario.h"

#include <algorithm>

#include "core/file/blow_csv.h"
#include "core/file/text_input.h"

namespace drillwave {
namespace {

/// The scenario is at the top: enough for the largest scenario file with "# " before each of its lines.
constexpr std::size_t topBytes = std::size_t{1} << 22;

[[noreturn]] void refuse(const std::string& path, std::string reason) {
    throw ScenarioError(ScenarioError::Kind::unreadable, path, {{"", std::move(reason)}});
}

}  // namespace

bool isCsvName(std::string_view path) {
    constexpr std::string_view suffix = ".csv";
    if (path.size() < suffix.size()) return false;
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(path.substr(path.size() - suffix.size()), suffix, {}, lower);
}

ScenarioDocument loadResultScenario(const std::string& path) {
    const FileBytes top = readStart(path, topBytes);
    if (!top.problem.empty()) refuse(path, top.problem);
    const std::string yaml = scenarioFromHeader(top.bytes);
    if (yaml.empty())
        refuse(path, "holds no scenario; only CSV files written by `drillwave run -o` begin with one");
    return parseScenario(yaml, path);
}

ScenarioDocument loadScenarioOrResult(const std::string& path) {
    return isCsvName(path) ? loadResultScenario(path) : loadScenario(path);
}

std::string completeScenarioText(ScenarioDocument document) {
    document.scenario.pulse.tableFile.clear();
    return writeScenario(document);
}

}  // namespace drillwave
