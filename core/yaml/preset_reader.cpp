// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_reader.h"

#include <algorithm>

#include "core/model/parameter_text.h"
#include "core/model/validation.h"
#include "core/text/enum_names.h"
#include "core/text/name_text.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/preset_file.h"
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

void PresetList::readItems(const YamlNode& list, const std::function<void(const YamlNode&)>& read) {
    if (list.kind != YamlKind::sequence) {
        if (list.kind != YamlKind::null)
            m_reader.problems().reportKey(list.offset, m_key,
                                          translatable("must be a list of presets, `- name: …`"));
        return;
    }
    for (const YamlNode& item : list.children)
        if (item.kind == YamlKind::map)
            read(item);
        else
            m_reader.problems().reportKey(item.offset, m_key,
                                          translatable("each preset must begin with `name: …`"));
}

std::string PresetList::textOf(const YamlEntries& entries, const YamlNode& item, std::string_view key,
                               const char* missing) {
    const std::string path = joinedKey(m_key, key);
    const auto found = entries.find(key);
    if (found == entries.end()) {
        m_reader.problems().reportKey(item.offset, path, missing);
        return {};
    }
    const YamlNode& value = *found->second.value;
    if (value.kind != YamlKind::scalar || value.text.empty()) {
        m_reader.problems().reportKey(found->second.place(), path, translatable("must be text"));
        return {};
    }
    const Message problem = nameProblem(value.text);
    if (problem.isEmpty()) return value.text;
    m_reader.problems().reportValue(value.offset, path, value.text, problem);
    return {};
}

std::string PresetList::nameOf(const YamlEntries& entries, const YamlNode& item) {
    std::string name = textOf(entries, item, "name");
    if (!name.empty() && !m_names.insert(name).second)
        m_reader.problems().reportValue(entries.at("name").place(), joinedKey(m_key, "name"), name,
                                        translatable("is the name of another preset too"));
    return name;
}

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

/// One list of the file. Its keys are those of a section of a scenario, and some more of `drill`.
struct PresetReader::Section {
    std::string_view list;
    std::string_view section;
    PresetKind kind;
    std::vector<std::string_view> moreKeys;  // of numbers
    std::vector<std::string_view> words;     // keys of what is no number
};

namespace {

constexpr std::string_view formatKey = "drillwave_presets";

const YamlNode& itemOf(const YamlNode& pair, std::size_t index) {
    return pair.children[index];
}

}  // namespace

std::vector<Preset> PresetReader::read(const YamlNode& root) {
    static const std::vector<Section> sections{
        {"rods", "rod", PresetKind::rod, {}, {}},
        {"hammers", "pulse", PresetKind::hammer, {"blow_frequency"}, {"shape"}},
        {"rocks", "bit_rock", PresetKind::rock, {}, {lawKey, cornersKey}}};
    if (root.kind != YamlKind::map) {
        m_reader.problems().reportKey(root.offset, formatKey,
                                      translatable("the file must begin with `drillwave_presets: 1`"));
        return {};
    }
    if (!readFormat(root)) return {};
    std::vector<std::string_view> lists{formatKey, "rods", "hammers", "rocks"};
    lists.insert(lists.end(), sectionPresetLists().begin(), sectionPresetLists().end());
    const YamlEntries file = m_reader.entriesOf(root, "", lists);
    for (const Section& section : sections)
        if (const auto found = file.find(section.list); found != file.end())
            readList(*found->second.value, section);
    m_sectionPresets = readSectionPresets(m_reader, file);
    return std::move(m_presets);
}

bool PresetReader::readFormat(const YamlNode& root) {
    if (root.children.empty() || itemOf(root, 0).text != formatKey) {
        m_reader.problems().reportKey(
            root.offset, formatKey,
            translatable("is missing: the first line must be `drillwave_presets: 1`"));
        return true;
    }
    const YamlNode& value = itemOf(root, 1);
    if (value.text == std::to_string(presetFormat)) return true;
    m_reader.problems().reportValue(
        value.offset, formatKey, value.text,
        {translatable("this program reads the format %1"), {std::to_string(presetFormat)}});
    return false;
}

void PresetReader::readList(const YamlNode& list, const Section& section) {
    PresetList presets(m_reader, section.list);
    presets.readItems(list, [&](const YamlNode& item) { readPreset(presets, item, section); });
}

void PresetReader::readPreset(PresetList& list, const YamlNode& item, const Section& section) {
    std::vector<std::string_view> known{"name"};
    known.insert(known.end(), section.words.begin(), section.words.end());
    for (const Parameter& parameter : parameters())
        if (parameter.section() == section.section) known.push_back(parameter.localKey());
    known.insert(known.end(), section.moreKeys.begin(), section.moreKeys.end());

    const YamlEntries entries = m_reader.entriesOf(item, section.section, known);
    const YamlEntries values = valuesOf(entries, section);
    m_reader.scenario() = Scenario();
    m_reader.setPlace(section.section, item.offset);
    Preset preset;
    preset.kind = section.kind;
    preset.name = list.nameOf(entries, item);
    const bool isKindKnown = readKind(preset, values, entries);
    readValues(preset, values, entries, section, isKindKnown);
    requireKeys(preset, entries, item);
    checkPhysics(item, section);
    m_presets.push_back(std::move(preset));
}

/// The values without their sources, as a scenario would have them. Pairs that are none are reported.
YamlEntries PresetReader::valuesOf(const YamlEntries& entries, const Section& section) {
    YamlEntries values;
    for (const auto& [key, entry] : entries) {
        if (key == "name") continue;
        const YamlNode& pair = *entry.value;
        const bool isPair = pair.kind == YamlKind::sequence && pair.children.size() == 2 &&
                            itemOf(pair, 1).kind == YamlKind::scalar && !itemOf(pair, 1).text.empty();
        if (isPair) values.emplace(key, YamlEntry{entry.key, &itemOf(pair, 0)});
        if (const Message problem = isPair ? nameProblem(itemOf(pair, 1).text) : Message();
            !problem.isEmpty())
            m_reader.problems().reportValue(itemOf(pair, 1).offset, joinedKey(section.section, key),
                                            itemOf(pair, 1).text, {translatable("the source %1"), {problem}});
        if (!isPair)
            m_reader.problems().reportKey(
                entry.place(), joinedKey(section.section, key),
                translatable("must be [value, source]; write `assumed` if there is no source"));
    }
    return values;
}

/// The shape of a hammer or the loading curve of a rock, without which there is no telling what applies.
bool PresetReader::readKind(Preset& preset, const YamlEntries& values, const YamlEntries& entries) {
    switch (preset.kind) {
        case PresetKind::rod:
            break;
        case PresetKind::hammer:
            return readShape(preset, values, entries);
        case PresetKind::rock:
            return readCurve(preset, values, entries);
    }
    return false;
}

bool PresetReader::readShape(Preset& preset, const YamlEntries& values, const YamlEntries& entries) {
    const auto found = values.find("shape");
    if (found == values.end()) return false;
    const YamlNode& value = *found->second.value;
    const std::optional<PulseShape> shape = findPulseShape(value.text);
    if (!shape || shape == PulseShape::table || shape == PulseShape::rigidBody) {
        m_reader.problems().reportValue(found->second.place(), pulseShapeKey, value.text,
                                        translatable("must be a shape of a hammer blow that needs no table"));
        return false;
    }
    preset.shape = m_reader.scenario().pulse.shape = *shape;
    preset.shapeSource = itemOf(*entries.at("shape").value, 1).text;
    return true;
}

bool PresetReader::readCurve(Preset& preset, const YamlEntries& values, const YamlEntries& entries) {
    // What has no source is reported already.
    const auto isLeftOut = [&](std::string_view key) {
        return entries.contains(key) && !values.contains(key);
    };
    if (isLeftOut(lawKey) || !readLaw(m_reader, values)) return false;
    if (!isLeftOut(cornersKey)) readCorners(m_reader, values);
    preset.law = m_reader.scenario().bitRock.law;
    preset.corners = m_reader.scenario().bitRock.corners;
    for (const std::string_view key : {lawKey, cornersKey}) {
        if (!values.contains(key)) continue;
        const std::string& source = itemOf(*entries.find(key)->second.value, 1).text;
        if (preset.lawSource.empty())
            preset.lawSource = source;
        else if (source != preset.lawSource)
            preset.lawSource += "; corners: " + source;
    }
    return true;
}

void PresetReader::readValues(Preset& preset, const YamlEntries& values, const YamlEntries& entries,
                              const Section& section, bool isKindKnown) {
    const auto applicability =
        isKindKnown ? SectionReader::Applicability::checked : SectionReader::Applicability::ignored;
    m_reader.readParameters(values, section.section, applicability);
    if (!section.moreKeys.empty()) {
        YamlEntries more;
        for (const std::string_view key : section.moreKeys)
            if (const auto found = values.find(key); found != values.end()) more.insert(*found);
        m_reader.readParameters(more, "drill", SectionReader::Applicability::ignored);
    }
    for (const Parameter& parameter : parameters()) {
        const auto found = values.find(parameter.localKey());
        const bool isMore =
            parameter.section() == "drill" &&
            std::ranges::find(section.moreKeys, parameter.localKey()) != section.moreKeys.end();
        if (found == values.end() || (parameter.section() != section.section && !isMore)) continue;
        if (!parameter.applies(m_reader.scenario())) continue;
        if (const std::optional<double> si = parameter.value(m_reader.scenario()))
            preset.values.push_back(
                {&parameter, *si, itemOf(*entries.at(std::string(parameter.localKey())).value, 1).text});
    }
}

void PresetReader::requireKeys(const Preset& preset, const YamlEntries& entries, const YamlNode& item) {
    switch (preset.kind) {
        case PresetKind::rod:
            m_reader.requireOneOf(entries, "rod", "diameter", "area");
            if (entries.contains("diameter")) m_reader.require(entries, *findParameter("rod.bore"));
            if (entries.contains("area") && entries.contains("bore"))
                m_reader.problems().reportKey(item.offset, "rod.bore",
                                              translatable("goes with a diameter, not with an area"));
            break;
        case PresetKind::hammer:
            m_reader.requireShape(entries);
            if (preset.shape) m_reader.requireParameters(entries, "pulse");
            break;
        case PresetKind::rock:
            m_reader.requireParameters(entries, "bit_rock");
            break;
    }
}

/// Values each of which may be while all of them together may not.
void PresetReader::checkPhysics(const YamlNode& item, const Section& section) {
    if (!m_reader.problems().empty()) return;
    for (InputProblem& problem : validate(m_reader.scenario())) {
        if (!problem.key.starts_with(section.section)) continue;
        const std::size_t place = m_reader.placeOf(problem.key).value_or(item.offset);
        m_reader.problems().reportAt(place, std::move(problem));
    }
}

}  // namespace drillwave
