// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_remarks.h"

#include <algorithm>

#include "core/text/text_edit.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/scenario_reader.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_extent.h"

namespace drillwave {
namespace {

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
