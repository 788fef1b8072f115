// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_file.h"

#include "core/disk/file_bytes.h"
#include "core/text/text_input.h"
#include "core/yaml/preset_reader.h"
#include "core/yaml/preset_text.h"

namespace drillwave {
namespace {

[[noreturn]] void refuse(ScenarioError::Kind kind, std::string_view text, const std::string& source,
                         std::size_t offset, Message reason) {
    const TextPosition at = positionOf(text, offset);
    throw ScenarioError(kind, source, {{"", reason, at.line, at.column}});
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

}  // namespace drillwave
