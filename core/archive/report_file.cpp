// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/report_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/archive/result_scenario.h"
#include "core/model/law_parameter.h"
#include "core/report/parameter_words.h"
#include "core/signal/signal_quality.h"
#include "core/text/printed_text.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_extent.h"

namespace drillwave {
namespace {

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

    /// `section` is a path such as "rod" or "string.2.of.1", empty for the top level.
    std::optional<Stated> find(std::string_view section, std::string_view key) const {
        const YamlNode* map = node(section);
        const YamlNode* value = map ? child(*map, key) : nullptr;
        if (!value || value->kind != YamlKind::scalar) return std::nullopt;
        const std::optional<TextExtent> extent = extentOf(m_text, *value);
        if (!extent) return Stated{value->text, {}};
        const std::size_t end = map->flow ? behindBrace(*map) : extent->end;
        const TextExtent comment = commentBehind(m_text, end);
        return Stated{value->text, wordsOf(m_text.substr(comment.begin, comment.end - comment.begin))};
    }

    /// Behind the key of a list: "hammer.sections".
    std::string behindKey(std::string_view list) const {
        const std::size_t dot = list.rfind('.');
        if (dot == std::string_view::npos) return {};
        const YamlNode* map = node(list.substr(0, dot));
        if (!map || map->kind != YamlKind::map) return {};
        for (std::size_t i = 0; i + 1 < map->children.size(); i += 2) {
            const YamlNode& key = map->children[i];
            if (key.text != list.substr(dot + 1)) continue;
            const std::size_t colon = m_text.find(':', key.offset);
            if (colon == std::string_view::npos) return {};
            const TextExtent comment = commentBehind(m_text, colon + 1);
            return wordsOf(m_text.substr(comment.begin, comment.end - comment.begin));
        }
        return {};
    }

  private:
    const YamlNode* node(std::string_view path) const {
        const YamlNode* at = &m_tree.root;
        while (at && !path.empty()) {
            const std::string_view step = path.substr(0, path.find('.'));
            path.remove_prefix(std::min(step.size() + 1, path.size()));
            at = child(*at, step);
        }
        return at;
    }

    /// Returns the child of a map by its key, or of a list by its number from 0.
    static const YamlNode* child(const YamlNode& map, std::string_view key) {
        if (map.kind == YamlKind::sequence) {
            std::size_t index = map.children.size();
            std::from_chars(key.data(), key.data() + key.size(), index);
            return index < map.children.size() ? &map.children[index] : nullptr;
        }
        return map.valueOf(key);
    }

    /// Returns the end of values in braces: a remark after the brace applies to all of them.
    std::size_t behindBrace(const YamlNode& map) const {
        const std::size_t brace = m_text.find('}', map.children.back().offset);
        return brace == std::string_view::npos ? m_text.size() : brace + 1;
    }

    std::string_view m_text;
    YamlTree m_tree;
};

Message ofPreset(const std::string& name, const std::string& source) {
    return {translatable("preset %1: %2"), {name, source}};
}

Message notStated() {
    return translatable("not stated");
}

/// "preset T38, round 38 mm: nominal" of the first preset that the scenario follows in everything.
Message presetSource(const Scenario& scenario, const SavedValue& saved) {
    for (const Preset& preset : builtInPresets()) {
        if (!matches(preset, scenario)) continue;
        if (const std::string source = presetSource(preset, saved); !source.empty())
            return ofPreset(preset.name, source);
    }
    return {};
}

Message sourceOf(const Scenario& scenario, const SavedValue& saved, const std::optional<Stated>& stated) {
    if (stated && !stated->comment.empty()) return stated->comment;
    if (Message source = presetSource(scenario, saved); !source.isEmpty()) return source;
    return stated ? notStated() : translatable("assumed by the program");
}

/// In the unit of the text where that says the same value.
std::string shownValue(const SavedValue& saved, const std::optional<Stated>& stated) {
    if (!saved.unit) return saved.text;
    if (!stated) return valueText(saved);
    const TypedQuantity typed = parseQuantity(stated->text, saved.unit->quantity);
    return typed.valid() && typed.si == saved.number ? stated->text : valueText(saved);
}

/// "half sine".
std::string wordsOf(PulseShape shape) {
    std::string words(name(shape));
    std::ranges::replace(words, '_', ' ');
    return words;
}

ReportInput inputOf(const Scenario& scenario, const SavedValue& saved, const ScenarioRemarks& remarks) {
    const std::optional<Stated> stated = remarks.find(saved.section, saved.key);
    const std::string key = std::string(saved.section) + "." + std::string(saved.key);
    ReportInput input{key, {}, shownValue(saved, stated), {}, sourceOf(scenario, saved, stated)};
    if (!saved.parameter) {
        if (saved.key == "restrike") {
            input.label = translatable("hammer may strike again");
            input.word = scenario.drillString.hammer.restrike ? translatable("yes") : translatable("no");
            return input;
        }
        if (saved.key == lawKey) {
            input.label = translatable("law of bit and rock");
            input.word = Message::ofTable(phrase(scenario.bitRock.law));
            return input;
        }
        if (key == rockIndexingKey) {
            input.label = translatable("rock at the next blow");
            return input;
        }
        const bool isFile = saved.key != "shape";
        input.label = isFile ? translatable("table of the blow") : translatable("shape of the blow");
        if (isFile)
            input.source = translatable("its points are in the scenario");
        else
            input.word = Message::ofTable(wordsOf(scenario.pulse.shape));
        return input;
    }
    input.key = saved.parameter->key;
    input.si = saved.number;
    input.quantity = saved.parameter->quantity;
    input.label = titleMessage(*saved.parameter, printedWords(saved.parameter->symbol));
    return input;
}

Message inScenario() {
    return translatable("in the scenario");
}

/// The force or slope of a corner of the law.
ReportInput cornerInput(const Scenario& scenario, const Parameter& parameter) {
    const KeptParameter corner = inFormOf(scenario, parameter);
    const double si = corner->value(scenario).value_or(std::nan(""));
    return {std::string(corner->key),
            labelMessage(*corner),
            formatQuantity(si, corner->quantity, corner->displayUnit()),
            si,
            inScenario(),
            corner->quantity};
}

/// A section of a list, or the number of its repeats.
bool isOfList(const SavedValue& saved) {
    return saved.section.find('.') != std::string::npos;
}

/// The preset that a section is, and its source.
Message presetSource(const Section& section) {
    for (const SectionPreset& preset : builtInSectionPresets())
        if (std::ranges::find(preset.sections, section) != preset.sections.end())
            return ofPreset(preset.name, preset.source);
    return {};
}

/// Returns the remarks after the values of a section, each once; without any, the remark after its list, or
/// else its preset.
Message sourceOf(const Section& section, const std::string& path, const std::vector<std::string>& remarks,
                 const ScenarioRemarks& text) {
    std::string source;
    for (auto remark = remarks.begin(); remark != remarks.end(); ++remark)
        if (std::find(remarks.begin(), remark, *remark) == remark)
            source += (source.empty() ? "" : "; ") + *remark;
    if (source.empty()) source = text.behindKey(path.substr(0, path.rfind('.')));
    if (!source.empty()) return source;
    const Message preset = presetSource(section);
    return preset.isEmpty() ? notStated() : preset;
}

ReportSection sectionOf(const std::vector<SavedValue>& saved, const Section& section, const std::string& path,
                        const ScenarioRemarks& text) {
    ReportSection found;
    found.name = section.name;
    std::vector<std::string> remarks;
    for (const SavedValue& value : saved) {
        if (value.section != path || !value.unit || value.isDefault) continue;
        const std::optional<Stated> stated = text.find(path, value.key);
        if (stated && !stated->comment.empty()) remarks.push_back(stated->comment);
        found.values.push_back({std::string(value.key), {}, shownValue(value, stated), value.number, {}});
    }
    found.source = sourceOf(section, path, remarks, text);
    return found;
}

/// Fewer points were set by hand, and are no record.
constexpr std::size_t fewestOfRecord = 50;

/// Returns remarks on the record of a blow: those of its reading, or on the points of a table in a file.
std::vector<Message> recordRemarksOf(const ScenarioDocument& document) {
    const Pulse& pulse = document.scenario.pulse;
    if (pulse.shape != PulseShape::table || pulse.tableFile.empty()) return document.recordRemarks;
    if (pulse.tablePoints.size() < fewestOfRecord) return {};
    Samples samples;
    for (const auto& [time, force] : pulse.tablePoints) {
        samples.time.push_back(time);
        samples.value.push_back(force);
    }
    std::vector<Message> remarks;
    for (const SignalRemark& remark : qualityRemarks(signalQuality(samples), samples))
        remarks.push_back(about(pulse.tableFile, remark.text));
    return remarks;
}

}  // namespace

std::vector<ReportSection> sectionsOf(const Scenario& scenario, std::string_view text) {
    const ScenarioRemarks remarks(text);
    const std::vector<SavedValue> saved = savedValues(scenario);
    const DrillString& drill = scenario.drillString;
    std::vector<ReportSection> found;
    for (std::size_t i = 0; i < drill.hammer.sections.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        found.push_back(
            sectionOf(saved, drill.hammer.sections[i], "hammer.sections." + std::to_string(i), remarks));
        found.back().key = "hammer." + number;
        found.back().place = {translatable("hammer %1"), {number}};
    }
    std::size_t next = 0;
    const std::vector<PlacedSection> placed = placedSections(drill);
    for (std::size_t i = 0; i < drill.parts.size(); ++i) {
        const StringPart& part = drill.parts[i];
        const std::string path = "string." + std::to_string(i);
        for (std::size_t k = 0; k < part.sections.size(); ++k) {
            found.push_back(sectionOf(saved, part.sections[k],
                                      part.group ? path + ".of." + std::to_string(k) : path, remarks));
            const std::string number = std::to_string(placed[next++].place);
            found.back().place = number;
            found.back().key = "string." + number;
            found.back().times = part.repeat;
        }
    }
    return found;
}

std::vector<ReportInput> inputsOf(const Scenario& scenario, std::string_view text) {
    const ScenarioRemarks remarks(text);
    std::vector<ReportInput> inputs;
    for (const SavedValue& saved : savedValues(scenario)) {
        const bool isUsualWord = (saved.key == lawKey || saved.key == "indexing") && saved.isDefault;
        if ((saved.parameter || !saved.section.empty()) && !isOfList(saved) && !isUsualWord)
            inputs.push_back(inputOf(scenario, saved, remarks));
    }
    for (std::size_t place = 1; place <= scenario.bitRock.corners.size(); ++place)
        for (const std::string_view field : {"force", "slope"})
            inputs.push_back(cornerInput(scenario, *findParameter(cornerKey(place, field))));
    if (const TablePoints& points = scenario.pulse.tablePoints;
        scenario.pulse.shape == PulseShape::table && scenario.pulse.tableFile.empty())
        inputs.push_back({"pulse.points", translatable("points of the blow"), std::to_string(points.size()),
                          static_cast<double>(points.size()), inScenario()});
    return inputs;
}

BlowReport reportOn(const ScenarioDocument& document, const std::stop_token& stop,
                    const GapProgress& progress, const WorkLimits& limits) {
    BlowReport report = studyReport(document.scenario, stop, progress, limits);
    report.scenarioText = completeScenarioText(document);
    report.recordRemarks = recordRemarksOf(document);
    report.inputs = inputsOf(document.scenario, report.scenarioText);
    report.sections = sectionsOf(document.scenario, report.scenarioText);
    return report;
}

}  // namespace drillwave
