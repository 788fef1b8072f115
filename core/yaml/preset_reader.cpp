// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_reader.h"

#include <algorithm>

#include "core/text/name_text.h"
#include "core/yaml/law_reader.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/section_preset_reader.h"

namespace drillwave {

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
                translatable("must be [value, source], the source being `assumed` where there is none"));
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
