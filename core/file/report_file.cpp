// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/report_file.h"

#include <algorithm>

#include "core/file/preset_file.h"
#include "core/file/preset_remarks.h"
#include "core/file/result_scenario.h"
#include "core/file/scenario_text.h"
#include "core/file/yaml_extent.h"

namespace drillwave {
namespace {

using Kind = YamlNode::Kind;

/// The words of a comment, without its "#".
std::string wordsOf(std::string_view comment) {
    const std::size_t first = comment.find_first_not_of("# \t");
    if (first == std::string_view::npos) return {};
    return std::string(comment.substr(first, comment.find_last_not_of(" \t") + 1 - first));
}

/// A value as it stands in the text, and what is remarked behind it.
struct Stated {
    std::string text;
    std::string comment;
};

class ScenarioRemarks {
  public:
    explicit ScenarioRemarks(std::string_view text) : m_text(text), m_tree(parseYaml(text)) {}

    std::optional<Stated> find(std::string_view section, std::string_view key) const {
        const YamlNode* map = section.empty() ? &m_tree.root : child(m_tree.root, section);
        const YamlNode* value = map ? child(*map, key) : nullptr;
        if (!value || value->kind != Kind::scalar) return std::nullopt;
        const std::optional<TextExtent> extent = extentOf(m_text, *value);
        if (!extent) return Stated{value->text, {}};
        const std::size_t end = map->flow ? behindBrace(*map) : extent->end;
        const TextExtent comment = commentBehind(m_text, end);
        return Stated{value->text, wordsOf(m_text.substr(comment.begin, comment.end - comment.begin))};
    }

  private:
    static const YamlNode* child(const YamlNode& map, std::string_view key) {
        if (map.kind != Kind::map) return nullptr;
        for (std::size_t i = 0; i + 1 < map.children.size(); i += 2)
            if (map.children[i].text == key) return &map.children[i + 1];
        return nullptr;
    }

    /// What stands behind values in braces is about all of them.
    std::size_t behindBrace(const YamlNode& map) const {
        const std::size_t brace = m_text.find('}', map.children.back().offset);
        return brace == std::string_view::npos ? m_text.size() : brace + 1;
    }

    std::string_view m_text;
    YamlTree m_tree;
};

/// "preset T38, round 38 mm: nominal" of the first preset that the scenario follows in everything.
std::string presetSource(const Scenario& scenario, const SavedValue& saved) {
    for (const Preset& preset : builtInPresets()) {
        if (!matches(preset, scenario)) continue;
        if (!saved.parameter && preset.shape && saved.key == "shape")
            return presetRemark(preset, preset.shapeSource);
        for (const PresetValue& value : preset.values)
            if (value.parameter == saved.parameter && saved.parameter)
                return presetRemark(preset, value.source);
    }
    return {};
}

std::string sourceOf(const Scenario& scenario, const SavedValue& saved, const std::optional<Stated>& stated) {
    if (stated && !stated->comment.empty()) return stated->comment;
    if (std::string source = presetSource(scenario, saved); !source.empty()) return source;
    return stated ? "not stated" : "assumed by the program";
}

/// In the unit of the text where that says the same value.
std::string shownValue(const SavedValue& saved, const std::optional<Stated>& stated) {
    if (!saved.parameter) return saved.text;
    if (!stated) return valueText(saved);
    const TypedQuantity typed = parseQuantity(stated->text, saved.parameter->quantity);
    return typed.valid() && typed.si == saved.number ? stated->text : valueText(saved);
}

/// "t₀" for "t0".
std::string printedSymbol(std::string_view symbol) {
    const std::size_t zero = symbol.find('0');
    if (zero == std::string_view::npos) return std::string(symbol);
    return std::string(symbol.substr(0, zero)) + "₀" + std::string(symbol.substr(zero + 1));
}

ReportInput inputOf(const Scenario& scenario, const SavedValue& saved, const ScenarioRemarks& remarks) {
    const std::optional<Stated> stated = remarks.find(saved.section, saved.key);
    const std::string key = std::string(saved.section) + "." + std::string(saved.key);
    ReportInput input{key, {}, shownValue(saved, stated), {}, sourceOf(scenario, saved, stated)};
    if (!saved.parameter) {
        const bool isFile = saved.key != "shape";
        input.label = isFile ? "table of the blow" : "shape of the blow";
        if (isFile) input.source = "its points are in the scenario";
        return input;
    }
    input.key = saved.parameter->key;
    input.si = saved.number;
    input.label = saved.parameter->label;
    if (const std::string symbol = printedSymbol(saved.parameter->symbol); !symbol.empty())
        input.label += " " + symbol;
    return input;
}

}  // namespace

std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text) {
    const ScenarioRemarks remarks(text);
    std::vector<ReportInput> inputs;
    for (const SavedValue& saved : savedValues(scenario))
        if (!saved.section.empty()) inputs.push_back(inputOf(scenario, saved, remarks));
    if (const TablePoints& points = scenario.pulse.tablePoints;
        scenario.pulse.shape == PulseShape::table && scenario.pulse.tableFile.empty())
        inputs.push_back({"pulse.points", "points of the blow", std::to_string(points.size()) + " points",
                          static_cast<double>(points.size()), "in the scenario"});
    return inputs;
}

BlowReport reportOn(const ScenarioDocument& document, const std::stop_token& stop,
                    const GapProgress& progress) {
    BlowReport report = studyReport(document.scenario, stop, progress);
    report.scenarioText = completeScenarioText(document);
    report.inputs = inputsOf(document.scenario, report.scenarioText);
    if (report.thrust) report.thrust->scenarioText = report.scenarioText;
    if (report.gap) report.gap->scenarioText = report.scenarioText;
    return report;
}

}  // namespace drillwave
