// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/design_texts.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/preset.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

std::optional<PresetPart> partOf(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    return findPresetPart(trimmed(text.substr(0, equals)));
}

std::vector<PartPreset> presetsFor(PresetPart part, const Scenario& scenario, const PresetFile& file) {
    std::vector<PartPreset> suitable;
    const auto add = [&](PartPreset preset) {
        if (suits(preset, part, scenario)) suitable.push_back(std::move(preset));
    };
    for (const Preset& preset : file.presets) add(preset);
    for (const SectionPreset& preset : file.sectionPresets) add(preset);
    return suitable;
}

bool isPresetName(std::string_view name, const PresetFile& file) {
    const std::string low = lowerCase(std::string(name));
    for (const Preset& preset : file.presets)
        if (lowerCase(preset.name) == low) return true;
    for (const SectionPreset& preset : file.sectionPresets)
        if (lowerCase(preset.name) == low) return true;
    return false;
}

Message unsuitable(PresetPart part, const Scenario& scenario) {
    if (part == PresetPart::bit) return translatable("is not a bit; give the preset of a bit");
    if (part == PresetPart::rod) return translatable("is not a rod; give the preset of a rod");
    if (part == PresetPart::rock) return translatable("is not a rock; give the preset of a rock");
    return isForced(scenario) ? translatable("does not fit a uniform rod; give the preset of a hammer")
                              : translatable("does not fit a drill string; give the preset of a piston");
}

/// Names may have commas: the longest run of items that is the name of a preset is one.
class NameList {
  public:
    NameList(std::string_view text, const PresetFile& file) : m_file(file) {
        for (;;) {
            const std::size_t comma = text.find(',');
            m_items.push_back(text.substr(0, comma));
            if (comma == std::string_view::npos) break;
            text.remove_prefix(comma + 1);
        }
    }

    std::vector<std::string_view> wanted() const {
        std::vector<std::string_view> wanted;
        for (std::size_t i = 0; i < m_items.size();) {
            std::size_t last = m_items.size() - 1;
            while (last > i && !isPresetName(run(i, last), m_file)) --last;
            wanted.push_back(run(i, last));
            i = last + 1;
        }
        return wanted;
    }

  private:
    std::string_view run(std::size_t first, std::size_t last) const {
        const char* end = m_items[last].data() + m_items[last].size();
        return trimmed({m_items[first].data(), static_cast<std::size_t>(end - m_items[first].data())});
    }

    const PresetFile& m_file;
    std::vector<std::string_view> m_items;
};

ParsedAxis parsePresets(PresetPart part, std::string_view text, const Scenario& scenario,
                        const PresetLookup& lookup) {
    ParsedAxis parsed;
    const std::string key(name(part));
    if (Message problem = partProblem(part, scenario); !problem.isEmpty()) {
        parsed.kind = ParsedAxis::Kind::badValue;
        parsed.problem = about(key, problem);
        return parsed;
    }
    const PresetFile& file = lookup.presets();
    const std::vector<PartPreset> suitable = presetsFor(part, scenario, file);
    std::vector<std::string_view> names;
    for (const PartPreset& preset : suitable) names.emplace_back(nameOf(preset));
    std::vector<PartPreset> chosen;
    const std::string_view list = text.substr(text.find('=') + 1);
    const bool isAll = trimmed(list) == "all" && !suitable.empty();
    if (isAll) chosen = suitable;
    for (const std::string_view wanted :
         isAll ? std::vector<std::string_view>() : NameList(list, file).wanted()) {
        FoundName found = findPresetName(names, wanted, lookup.listCommand);
        if (!found.problem.isEmpty()) {
            const bool isOther = isPresetName(wanted, file);  // of another kind
            if (isOther) parsed.kind = ParsedAxis::Kind::badValue;
            parsed.problem = about(key + " " + shortened(wanted),
                                   isOther ? unsuitable(part, scenario) : std::move(found.problem));
            return parsed;
        }
        chosen.push_back(suitable[found.number]);
    }
    SweepAxis& axis = parsed.axis;
    axis.kind = SweepAxis::Kind::presets;
    axis.count = chosen.size();
    for (std::size_t i = 0; i < chosen.size(); ++i) axis.list.push_back(static_cast<double>(i));
    axis.presets = SharedPresetChoice(std::make_shared<const PresetChoice>(part, std::move(chosen)));
    return parsed;
}

/// "thrust@q95" as its parts, with what is wrong.
struct OutputStatistic {
    const Output* output = nullptr;
    Statistic statistic;
    Message problem;
};

OutputStatistic readStatistic(std::string_view word) {
    const std::size_t at = word.find('@');
    if (at == std::string_view::npos)
        return {{}, {}, {translatable("`%1` needs OUTPUT@STATISTIC, as efficiency@q05"), {shortened(word)}}};
    const OutputChoice output = chooseOutputs(word.substr(0, at), OutputUnits::dimensionless);
    if (!output.problem.isEmpty()) return {{}, {}, output.problem};
    if (output.all) return {{}, {}, translatable("`all` means several outputs; name one")};
    const std::string_view statistic = trimmed(word.substr(at + 1));
    const std::optional<Statistic> found = findStatistic(statistic);
    if (!found)
        return {{},
                {},
                {translatable("`%1` is not a statistic; choose from mean, q01 to q99, min, max, nominal"),
                 {shortened(statistic)}}};
    return {output.columns.front().output, *found, {}};
}

}  // namespace

PresetLookup builtInLookup() {
    return {.presets = []() -> const PresetFile& { return builtInPresetFile(); }};
}

ParsedAxis parseAxisOrPresets(std::string_view text, const Scenario& scenario, const PresetLookup& lookup) {
    if (const std::optional<PresetPart> part = partOf(text))
        return parsePresets(*part, text, scenario, lookup);
    return parseAxis(text);
}

bool choosesPresets(std::string_view text) {
    return partOf(text).has_value();
}

ParsedAxis parseChoice(std::string_view text, const Scenario& scenario, const PresetLookup& lookup) {
    if (partOf(text) == PresetPart::rock)
        return {.axis = {},
                .problem = translatable("a design does not choose its rock; vary the rock with --uncertain, "
                                        "such as bit_rock.stiffness=50MN/m:250MN/m")};
    return parseAxisOrPresets(text, scenario, lookup);
}

bool beginsAsAim(std::string_view text) {
    return text.starts_with("max:") || text.starts_with("min:");
}

ParsedAim parseAim(std::string_view text) {
    if (!beginsAsAim(text)) return {{}, translatable("needs max:OUTPUT@STATISTIC or min:OUTPUT@STATISTIC")};
    OutputStatistic read = readStatistic(text.substr(4));
    return {{text.starts_with("max") ? Sense::largest : Sense::least, read.output, read.statistic},
            std::move(read.problem)};
}

ParsedLimit parseLimit(std::string_view text, bool atMost, const Scenario& scenario) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return {{}, true, translatable("needs OUTPUT@STATISTIC=VALUE")};
    OutputStatistic read = readStatistic(trimmed(text.substr(0, equals)));
    if (!read.problem.isEmpty()) return {{}, true, std::move(read.problem)};
    const bool inUnit = hasUnits(scenario) || read.output->isOnlySi();
    TypedQuantity value = parseQuantity(
        text.substr(equals + 1), inUnit ? read.output->quantity() : Quantity::ratio, BareNumber::refused);
    if (!value.valid()) return {{}, false, std::move(value.problem)};
    return {{atMost, read.output, read.statistic, value.si}, false, {}};
}

}  // namespace drillwave
