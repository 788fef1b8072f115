// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/section_preset_reader.h"

#include "core/model/parameter_text.h"
#include "core/model/string_validation.h"
#include "core/text/enum_names.h"
#include "core/yaml/preset_list.h"
#include "core/yaml/string_reader.h"

namespace drillwave {
namespace {

constexpr EnumNames<SectionPresetKind> listNames{{{SectionPresetKind::piston, "pistons"},
                                                  {SectionPresetKind::adapter, "adapters"},
                                                  {SectionPresetKind::coupling, "couplings"},
                                                  {SectionPresetKind::bit, "bits"}}};

class ListReader {
  public:
    ListReader(SectionReader& reader, SectionPresetKind kind, std::string_view list)
        : m_reader(reader), m_kind(kind), m_key(list), m_list(reader, list) {}

    std::vector<SectionPreset> read(const YamlNode& list) {
        m_list.readItems(list, [this](const YamlNode& item) { readPreset(item); });
        return std::move(m_presets);
    }

  private:
    std::string key(std::string_view local) const { return joinedKey(m_key, local); }

    void readPreset(const YamlNode& item) {
        std::vector<std::string_view> known{"name", "source", "strength_source", "sections"};
        if (m_kind == SectionPresetKind::piston) known.emplace_back("velocity");
        const YamlEntries entries = m_reader.entriesOf(item, m_key, known);
        SectionPreset preset;
        preset.kind = m_kind;
        preset.name = m_list.nameOf(entries, item);
        preset.source = m_list.textOf(entries, item, "source", "is missing: `assumed` where there is none");
        if (entries.contains("strength_source"))
            preset.strengthSource = m_list.textOf(entries, item, "strength_source");
        readVelocity(preset, entries);
        readSectionsOf(preset, entries, item);
        m_presets.push_back(std::move(preset));
    }

    void readVelocity(SectionPreset& preset, const YamlEntries& entries) {
        const auto found = entries.find("velocity");
        if (found == entries.end()) return;
        const Parameter& velocity = *findParameter("hammer.velocity");
        const YamlNode& value = *found->second.value;
        const TypedQuantity typed =
            parseQuantity(value.text, velocity.quantity, BareNumber::refused, &velocity.displayUnit());
        const Message reason = typed.valid() ? rangeProblem(velocity, typed.si) : typed.problem;
        if (reason.isEmpty())
            preset.velocity = typed.si;
        else
            m_reader.problems().reportValue(found->second.place(), key("velocity"), value.text, reason);
    }

    void readSectionsOf(SectionPreset& preset, const YamlEntries& entries, const YamlNode& item) {
        const auto found = entries.find("sections");
        if (found == entries.end() || found->second.value->kind != YamlKind::sequence ||
            found->second.value->children.empty()) {
            const std::size_t place = found == entries.end() ? item.offset : found->second.place();
            m_reader.problems().reportKey(
                place, key("sections"),
                translatable("must be a list of sections: `- {length: 300 mm, diameter: 50 mm}`"));
            return;
        }
        const bool wasGood = m_reader.problems().empty();
        preset.sections = readSectionList(m_reader, *found->second.value, key("sections"));
        for (Section& section : preset.sections) section.preset = preset.name;
        if (wasGood && m_reader.problems().empty()) checkTogether(preset, found->second.place());
    }

    /// Values each of which may be while all of them together may not.
    void checkTogether(const SectionPreset& preset, std::size_t place) {
        DrillString drill;
        drill.hammer.sections = preset.sections;
        drill.parts.resize(1);
        drill.parts.front().sections = {preset.sections.front()};
        constexpr std::string_view prefix = "hammer";
        for (InputProblem& problem : sectionProblems(drill)) {
            if (!problem.key.starts_with(prefix)) continue;
            problem.key.replace(0, prefix.size(), key("sections"));
            // Key and value stand first in what valueProblem() makes.
            if (Message& text = problem.text; !text.arguments.empty()) {
                std::string& given = text.arguments.front().pattern;
                if (given.starts_with(prefix)) given.replace(0, prefix.size(), key("sections"));
            }
            m_reader.problems().reportAt(place, std::move(problem));
        }
    }

    SectionReader& m_reader;
    SectionPresetKind m_kind;
    std::string_view m_key;
    PresetList m_list;
    std::vector<SectionPreset> m_presets;
};

}  // namespace

std::span<const std::string_view> sectionPresetLists() {
    return listNames.all();
}

std::vector<SectionPreset> readSectionPresets(SectionReader& reader, const YamlEntries& file) {
    std::vector<SectionPreset> presets;
    for (const SectionPresetKind kind : sectionPresetKinds) {
        const std::string_view list = listNames[kind];
        const auto found = file.find(list);
        if (found == file.end()) continue;
        std::vector<SectionPreset> read = ListReader(reader, kind, list).read(*found->second.value);
        std::move(read.begin(), read.end(), std::back_inserter(presets));
    }
    return presets;
}

}  // namespace drillwave
