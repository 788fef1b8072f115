// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/section_preset_reader.h"

#include <set>

#include "core/model/parameter_text.h"
#include "core/model/string_validation.h"
#include "core/text/enum_names.h"
#include "core/text/name_text.h"
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
        : m_reader(reader), m_kind(kind), m_list(list) {}

    std::vector<SectionPreset> read(const YamlNode& list) {
        if (list.kind == YamlKind::sequence)
            for (const YamlNode& item : list.children) readPreset(item);
        else if (list.kind != YamlKind::null)
            m_reader.problems().reportKey(list.offset, m_list, "must be a list of presets, `- name: …`");
        return std::move(m_presets);
    }

  private:
    std::string key(std::string_view local) const { return joinedKey(m_list, local); }

    void readPreset(const YamlNode& item) {
        if (item.kind != YamlKind::map) {
            m_reader.problems().reportKey(item.offset, m_list, "each preset must begin with `name: …`");
            return;
        }
        std::vector<std::string_view> known{"name", "source", "sections"};
        if (m_kind == SectionPresetKind::piston) known.push_back("velocity");
        const YamlEntries entries = m_reader.entriesOf(item, m_list, known);
        SectionPreset preset;
        preset.kind = m_kind;
        preset.name = readText(entries, item, "name");
        if (!preset.name.empty() && !m_names.insert(preset.name).second)
            m_reader.problems().reportValue(entries.at("name").place(), key("name"), preset.name,
                                            "is the name of another preset too");
        preset.source = readText(entries, item, "source");
        readVelocity(preset, entries);
        readSectionsOf(preset, entries, item);
        m_presets.push_back(std::move(preset));
    }

    std::string readText(const YamlEntries& entries, const YamlNode& item, std::string_view local) {
        const auto found = entries.find(local);
        if (found == entries.end()) {
            m_reader.problems().reportKey(
                item.offset, key(local),
                local == "source" ? "is missing: `assumed` where there is none" : "is missing");
            return {};
        }
        const YamlNode& value = *found->second.value;
        const bool isText = value.kind == YamlKind::scalar && !value.text.empty();
        const std::string problem = isText ? nameProblem(value.text) : std::string();
        if (!isText)
            m_reader.problems().reportKey(found->second.place(), key(local), "must be text");
        else if (!problem.empty())
            m_reader.problems().reportValue(found->second.place(), key(local), value.text, problem);
        return problem.empty() && isText ? value.text : std::string();
    }

    void readVelocity(SectionPreset& preset, const YamlEntries& entries) {
        const auto found = entries.find("velocity");
        if (found == entries.end()) return;
        const Parameter& velocity = *findParameter("hammer.velocity");
        const YamlNode& value = *found->second.value;
        const TypedQuantity typed =
            parseQuantity(value.text, velocity.quantity, BareNumber::refused, &velocity.displayUnit());
        const std::string reason = typed.valid() ? rangeProblem(velocity, typed.si) : typed.problem;
        if (reason.empty())
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
                place, key("sections"), "must be a list of sections: `- {length: 300 mm, diameter: 50 mm}`");
            return;
        }
        const bool wasGood = m_reader.problems().empty();
        preset.sections = readSectionList(m_reader, *found->second.value, key("sections"));
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
            if (problem.text.starts_with(prefix)) problem.text.replace(0, prefix.size(), key("sections"));
            problem.key.replace(0, prefix.size(), key("sections"));
            const TextPosition at = m_reader.problems().position(place);
            problem.line = at.line;
            problem.column = at.column;
            m_reader.problems().report(std::move(problem));
        }
    }

    SectionReader& m_reader;
    SectionPresetKind m_kind;
    std::string_view m_list;
    std::vector<SectionPreset> m_presets;
    std::set<std::string> m_names;
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
