// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preset_options.h"

#include <algorithm>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/scenario_argument.h"
#include "core/model/blow_traits.h"
#include "core/model/preset.h"
#include "core/text/decimal_text.h"
#include "core/text/enum_names.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& wanted, const Message& reason) {
    throw CommandError(ExitCode::usage, about(option + " " + shortened(wanted), reason));
}

/// The preset that findPresetName() finds. `file` is where they are from, empty for the built-in ones.
const Preset& presetNamed(const std::vector<Preset>& presets, PresetKind kind, const std::string& wanted,
                          const std::string& file) {
    std::vector<const Preset*> ofKind;
    std::vector<std::string_view> names;
    for (const Preset& preset : presets) {
        if (preset.kind != kind) continue;
        ofKind.push_back(&preset);
        names.emplace_back(preset.name);
    }
    const FoundName found =
        findPresetName(names, wanted, "drillwave presets" + (file.empty() ? file : " " + file));
    if (!found.problem.isEmpty()) refuse("--" + std::string(name(kind)), wanted, found.problem);
    return *ofKind[found.number];
}

}  // namespace

std::string_view name(PresetKind kind) {
    static constexpr EnumNames<PresetKind> names{
        {{PresetKind::rod, "rod"}, {PresetKind::hammer, "hammer"}, {PresetKind::rock, "rock"}}};
    return names[kind];
}

std::vector<OptionSpec> presetOptionSpecs() {
    return {{"rod", "NAME", "use the rod of this preset; `drillwave presets` lists rods, hammers and rocks"},
            {"hammer", "NAME", "use the hammer of this preset"},
            {"rock", "NAME", "use the rock of this preset"},
            {"presets", "FILE.yaml", "take presets from this file instead of the built-in ones"}};
}

PresetFile presetsOf(const std::optional<std::string>& path, const ReadingStyle& style) {
    if (!path) return builtInPresetFile();
    if (path->empty())
        throw CommandError(
            ExitCode::usage,
            translatable("the file of presets has an empty name; without one the built-in ones are taken"));
    const FileBytes file = readInput(*path, maximumPresetBytes + 1, style);
    if (!file.problem.isEmpty())
        throw CommandError(
            ExitCode::unreadableInput,
            std::vector{about(inputName(*path), {translatable("the file of presets %1"), {file.problem}})});
    return parsedPresets(file.bytes, *path);
}

PresetLookup presetLookup(const Arguments& arguments) {
    const std::optional<std::string> file = arguments.value("presets");
    return {.presets = [&arguments, file, kept = std::optional<PresetFile>()]() mutable -> const PresetFile& {
                if (!kept) kept = presetsOf(file, arguments.style());
                return *kept;
            },
            .listCommand = "drillwave presets" + (file ? " " + *file : std::string())};
}

PresetFile parsedPresets(std::string_view text, const std::string& path) {
    if (text.size() > maximumPresetBytes)
        throw CommandError(
            ExitCode::unreadableInput,
            std::vector{Message(translatable("%1: the file of presets is larger than the limit of %2 KiB"),
                                {inputName(path), std::to_string(maximumPresetBytes / 1024)})});
    try {
        return parsePresets(text, inputName(path));
    } catch (const ScenarioError& error) {
        rethrow(error);
    }
}

void applyPresets(Scenario& scenario, const Arguments& arguments, const std::string& path,
                  bool arePresetsChosen) {
    const std::optional<std::string> file = arguments.value("presets");
    std::vector<Preset> presets;
    for (const PresetKind kind : allValues<PresetKind>) {
        const std::optional<std::string> wanted = arguments.value(name(kind));
        if (!wanted) continue;
        const std::string option = "--" + std::string(name(kind));
        if (hasSections(scenario) && kind != PresetKind::rock)
            refuse(option, *wanted,
                   {translatable("%1 is a drill string: its sections are given one by one"), {path}});
        if (!hasUnits(scenario))
            refuse(option, *wanted,
                   {translatable(
                        "%1 is given by its dimensionless groups; presets need a scenario in physical units"),
                    {path}});
        if (presets.empty()) presets = presetsOf(file, arguments.style()).presets;
        scenario = withPreset(std::move(scenario),
                              presetNamed(presets, kind, *wanted, file.value_or(std::string())));
    }
    const bool used = arePresetsChosen || std::ranges::any_of(allValues<PresetKind>, [&](PresetKind kind) {
                          return arguments.has(name(kind));
                      });
    if (arguments.has("presets") && !used)
        throw CommandError(ExitCode::usage,
                           translatable("--presets applies to --rod, --hammer and --rock; add one of them"));
}

}  // namespace drillwave
