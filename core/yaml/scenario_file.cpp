// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_file.h"

#include <algorithm>
#include <cassert>

#include "core/disk/file_bytes.h"
#include "core/model/validation.h"
#include "core/text/text_input.h"
#include "core/yaml/design_setup_text.h"
#include "core/yaml/scenario_patch.h"
#include "core/yaml/scenario_reader.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {

namespace {

Message placed(const InputProblem& problem, const std::string& source) {
    std::string place = problem.source.empty() ? source : problem.source;
    if (problem.line > 0) place += (place.empty() ? "line " : ":") + std::to_string(problem.line);
    if (problem.line > 0 && problem.column > 0) place += ":" + std::to_string(problem.column);
    return place.empty() ? problem.text : Message("%1: %2", {place, problem.text});
}

std::string joinedLines(const std::vector<InputProblem>& problems, const std::string& source) {
    std::string text;
    for (const InputProblem& problem : problems)
        text += (text.empty() ? "" : "\n") + placed(problem, source).text();
    return text;
}

/// Whether the text says exactly this scenario and this design; a table file is taken to hold the scenario's
/// points.
bool says(std::string_view text, const Scenario& scenario, const DesignSetup& design,
          const std::string& source) {
    const ReadScenario read = readScenario(text, source, &scenario.pulse.tablePoints);
    return read.problems.empty() && read.scenario == scenario && read.design == design;
}

/// The comments in front of the first key: they explain the scenario and survive a file written anew.
std::string_view leadingComments(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size() && (text[at] == '#' || text[at] == '\n' || text[at] == '\r')) {
        const std::size_t lineEnd = text.find('\n', at);
        if (lineEnd == std::string_view::npos) return text;
        at = lineEnd + 1;
    }
    return text.substr(0, at);
}

bool isRemark(std::string_view line) {
    return line.starts_with(writtenRemark) || line.starts_with(solvedRemark) ||
           line.starts_with(columnsRemark);
}

}  // namespace

ScenarioError::ScenarioError(Kind kind, std::string source, std::vector<InputProblem> problems)
    : std::runtime_error(joinedLines(problems, source)),
      m_kind(kind),
      m_source(std::move(source)),
      m_problems(std::move(problems)) {}

std::vector<Message> ScenarioError::messages() const {
    std::vector<Message> messages;
    for (const InputProblem& problem : m_problems) messages.push_back(placed(problem, m_source));
    return messages;
}

std::vector<std::string> ScenarioError::lines() const {
    std::vector<std::string> lines;
    for (const Message& message : messages()) lines.push_back(message.text());
    return lines;
}

ScenarioDocument loadScenario(const std::string& path) {
    const FileBytes file = readFile(path, maximumScenarioBytes);
    if (!file.problem.isEmpty())
        throw ScenarioError(ScenarioError::Kind::unreadable, path,
                            {{"", {translatable("the scenario file %1"), {file.problem}}}});
    return parseScenario(file.bytes, path);
}

ScenarioDocument parseScenario(std::string_view text, const std::string& source) {
    if (text.size() > maximumScenarioBytes)
        throw ScenarioError(ScenarioError::Kind::unreadable, source,
                            {{"", translatable("the scenario is larger than 1 MiB")}});
    ReadScenario read = readScenario(text, source);
    if (!read.problems.empty())
        throw ScenarioError(read.unreadable ? ScenarioError::Kind::unreadable : ScenarioError::Kind::invalid,
                            source, std::move(read.problems));
    return {std::move(read.scenario), std::string(text), source, std::move(read.design)};
}

std::string writeScenario(const ScenarioDocument& document) {
    assert(validate(document.scenario).empty());
    const Scenario scenario = withoutUnusedValues(document.scenario);
    if (!document.text.empty()) {
        if (says(document.text, scenario, document.design, document.source)) return document.text;
        // Who solved the scenario of a result, and how, is not true of another one.
        const std::string_view text = std::string_view(document.text).substr(remarksLength(document.text));
        const std::optional<std::string> patched = patchedText(text, scenario, document.design);
        if (patched && patched->size() <= maximumScenarioBytes &&
            says(*patched, scenario, document.design, document.source))
            return *patched;
    }
    const std::string_view old = std::string_view(document.text).substr(remarksLength(document.text));
    std::string text =
        std::string(leadingComments(old)) + scenarioText(scenario) + designSetupText(document.design);
    if (text.size() > maximumScenarioBytes)
        throw ScenarioError(
            ScenarioError::Kind::invalid, document.source,
            {{"pulse.points", translatable("the scenario is larger than 1 MiB, the limit for files; keep the "
                                           "points of a table in a CSV file")}});
    return text;
}

std::size_t remarksLength(std::string_view yaml) {
    std::size_t length = byteOrderMarkLength(yaml);
    if (!yaml.substr(length).starts_with(writtenRemark)) return 0;
    for (std::string_view rest = yaml.substr(length); isRemark(rest); rest = yaml.substr(length))
        length += std::min(rest.find('\n'), rest.size() - 1) + 1;
    return length;
}

}  // namespace drillwave
