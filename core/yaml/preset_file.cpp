// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_file.h"

#include <algorithm>

#include "core/disk/file_bytes.h"
#include "core/text/text_edit.h"
#include "core/text/text_input.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/preset_reader.h"
#include "core/yaml/preset_text.h"
#include "core/yaml/scenario_reader.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_extent.h"

namespace drillwave {

namespace {

[[noreturn]] void refuse(ScenarioError::Kind kind, std::string_view text, const std::string& source,
                         std::size_t offset, Message reason) {
    const TextPosition at = positionOf(text, offset);
    throw ScenarioError(kind, source, {{"", reason, at.line, at.column}});
}

/// Behind a value that has its line to itself; nullopt elsewhere, and where a comment is.
std::optional<std::size_t> placeBehind(std::string_view text, const YamlNode& root, const SavedValue& saved) {
    const YamlNode* section = root.valueOf(saved.section);
    const YamlNode* value = section && !section->flow && !root.flow ? section->valueOf(saved.key) : nullptr;
    const std::optional<TextExtent> extent = value ? extentOf(text, *value) : std::nullopt;
    if (!extent) return std::nullopt;
    const std::size_t next = text.find_first_not_of(" \t", extent->end);
    const bool isLast = next == std::string_view::npos || text[next] == '\n' || text[next] == '\r';
    return isLast ? std::optional(extent->end) : std::nullopt;
}

/// "preset T38, round 38 mm: nominal", as it stands behind a value.
std::string presetRemark(const Preset& preset, const std::string& source) {
    return "preset " + preset.name + ": " + source;
}

}  // namespace

PresetFile parsePresets(std::string_view text, const std::string& source) {
    if (const TextProblem problem = checkText(text); !problem.reason.empty())
        refuse(ScenarioError::Kind::unreadable, text, source, problem.offset,
               {translatable("is not a text file: it holds %1"), {Message::ofTable(problem.reason)}});
    const YamlTree tree = parseYaml(text);
    if (!tree.problem.text.isEmpty())
        refuse(tree.problem.isYaml ? ScenarioError::Kind::invalid : ScenarioError::Kind::unreadable, text,
               source, tree.problem.offset, tree.problem.text);
    PresetReader reader(text);
    PresetFile file;
    file.presets = reader.read(tree.root);
    file.sectionPresets = reader.takeSectionPresets();
    std::vector<InputProblem> problems = reader.takeProblems();
    if (!problems.empty()) throw ScenarioError(ScenarioError::Kind::invalid, source, std::move(problems));
    return file;
}

PresetFile loadPresets(const std::string& path) {
    const FileBytes file = readFile(path, maximumPresetBytes);
    if (!file.problem.isEmpty())
        throw ScenarioError(ScenarioError::Kind::unreadable, path,
                            {{"", {translatable("the file of presets %1"), {file.problem}}}});
    return parsePresets(file.bytes, path);
}

const PresetFile& builtInPresetFile() {
    static const PresetFile file = parsePresets(presetText, "presets.yaml");
    return file;
}

std::span<const Preset> builtInPresets() {
    return builtInPresetFile().presets;
}

std::span<const SectionPreset> builtInSectionPresets() {
    return builtInPresetFile().sectionPresets;
}

std::string presetSource(const Preset& preset, const SavedValue& saved) {
    if (!saved.parameter && saved.key == lawKey) return preset.lawSource;
    if (!saved.parameter) return preset.shape && saved.key == "shape" ? preset.shapeSource : std::string();
    const auto found = std::ranges::find(preset.values, saved.parameter, &PresetValue::parameter);
    return found == preset.values.end() ? std::string() : found->source;
}

std::string writeWithPreset(const ScenarioDocument& document, const Preset& preset) {
    std::string text = writeScenario(document);
    const YamlTree tree = parseYaml(text);
    std::vector<TextEdit> edits;
    for (const SavedValue& saved : savedValues(document.scenario)) {
        const std::string source = presetSource(preset, saved);
        if (source.empty()) continue;
        const std::optional<std::size_t> place = placeBehind(text, tree.root, saved);
        if (!place) continue;
        std::string remark = "  # " + presetRemark(preset, source);
        // A comment is one line.
        std::ranges::replace_if(
            remark, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
        edits.push_back({*place, 0, std::move(remark)});
    }
    std::string remarked = edited(text, std::move(edits));
    return remarked.size() <= maximumScenarioBytes ? remarked : text;
}

}  // namespace drillwave
